#pragma once

#include "base/vec.h"
#include "surface/axes.h"

#include <array>

namespace vp::surface
{

// height(p) = q A q + b q + c with q = p - origin and A symmetric; S(x) = 1 if it is not negative. It is
// negative inside a sphere, a cylinder, a cone and an ellipsoid.
class Quadric
{
public:
	// xx, yy, zz, xy, xz, yz, x, y, z, 1.
	using Coefficients = std::array<double, 10>;

	explicit Quadric(const Coefficients& coefficients);

	static Quadric sphere(double radius);                   // about the origin
	static Quadric cylinder(double radius);                 // about the z axis
	static Quadric cone(double degrees);                    // about the z axis, both halves; half of the opening angle
	static Quadric ellipsoid(double x, double y, double z); // its half axes

	// Returns the quadric in world coordinates. This one is given in the coordinates of a frame.
	Quadric placed(const Axes& axes) const;

	double height(const Vec3& p) const
	{
		const Vec3 q = p - origin_;
		return q.x * (square_.x * q.x + mixed_.x * q.y + mixed_.y * q.z + linear_.x) +
		       q.y * (square_.y * q.y + mixed_.z * q.z + linear_.y) + q.z * (square_.z * q.z + linear_.z) + constant_;
	}
	// Returns the direction in which the height rises. It is not a unit vector, and zero if there is no single
	// direction.
	Vec3 gradient(const Vec3& p) const;
	// Returns the place of the surface on the way from a to b, 0 to 1. The height along an edge is quadratic, and this
	// is its root. The heights of a and b must have different signs.
	double crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const;
	// Returns true if the surface may pass through the box, its rim included.
	bool meets(const Box& box) const;

	const Vec3& origin() const { return origin_; }
	const Vec3& square() const { return square_; } // xx, yy, zz
	const Vec3& mixed() const { return mixed_; }   // xy, xz, yz: twice what stands in A
	const Vec3& linear() const { return linear_; }
	double constant() const { return constant_; }

	bool operator==(const Quadric&) const = default;

private:
	Vec3 times(const Vec3& q) const; // A q

	Vec3 origin_{0.0};
	Vec3 square_;
	Vec3 mixed_;
	Vec3 linear_;
	double constant_;
};

} // namespace vp::surface
