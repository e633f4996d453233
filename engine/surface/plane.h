#pragma once

#include "base/select.h"
#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace vp::surface
{

// The plane through `origin` with unit normal. S(x) = 1 if signedDistance(x) >= 0, so a vertex on the plane counts as
// positive. The normal is canonical (its first nonzero component is positive), so a plane and its flip give the same
// cut.
//
// The sign of a vertex is this one expression in double, the same for every cell around it. For this reason the build
// forbids fused multiply-add.
class Plane
{
public:
	// `normal` may have any length but zero.
	Plane(const Vec3& origin, const Vec3& normal);

	const Vec3& origin() const { return origin_; }
	const Vec3& normal() const { return normal_; }

	double signedDistance(const Vec3& p) const { return glm::dot(normal_, p - origin_); }

	// Returns true if the plane may pass through the box, its rim included.
	bool meets(const Box& box) const
	{
		const Vec3 half = 0.5 * box.size();
		const double reach = glm::dot(glm::abs(normal_), half);
		// Allows for rounding of center and half size, so that a face on the side of the box is not lost.
		const Vec3 reaches = glm::abs(box.lo) + glm::abs(box.hi) + glm::abs(origin_);
		const double slack = 1e-14 * (reaches.x + reaches.y + reaches.z);
		return std::abs(signedDistance(box.center())) <= reach + slack;
	}

	/// Returns the place of the plane on the edge from a to b, 0 to 1, from the distances of the ends. One of them must
	/// be negative. The place from b to a is 1 minus this one, also where it is exactly at an end.
	static double crossing(double distance_a, double distance_b)
	{
		const double positive = std::max(distance_a, distance_b);
		const double rest = 1.0 - positive / (positive - std::min(distance_a, distance_b)); // from the negative end
		return select(distance_a >= distance_b, 1.0 - rest, rest);
	}

private:
	Vec3 origin_;
	Vec3 normal_;
};

} // namespace vp::surface
