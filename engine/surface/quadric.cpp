#include "surface/quadric.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace vp::surface
{

Quadric::Quadric(const Coefficients& c)
    : square_(c[0], c[1], c[2]), mixed_(c[3], c[4], c[5]), linear_(c[6], c[7], c[8]), constant_(c[9])
{
}

Quadric Quadric::sphere(double radius)
{
	return ellipsoid(radius, radius, radius);
}

Quadric Quadric::cylinder(double radius)
{
	return Quadric({1.0 / (radius * radius), 1.0 / (radius * radius), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0});
}

Quadric Quadric::cone(double degrees)
{
	const double slope = std::tan(glm::radians(degrees));
	return Quadric({1.0, 1.0, -slope * slope, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
}

Quadric Quadric::ellipsoid(double x, double y, double z)
{
	return Quadric({1.0 / (x * x), 1.0 / (y * y), 1.0 / (z * z), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0});
}

// A' = R^T A R and b' = R^T b, R taking the world's vectors to the frame's: its rows are the axes.
Quadric Quadric::placed(const Axes& axes) const
{
	const glm::dmat3 frame(axes.x, axes.y, axes.z); // columns: R^T
	const auto entry = [&](int i, int j)
	{
		const auto row = [&](int at) { return Vec3(frame[0][at], frame[1][at], frame[2][at]); };
		return glm::dot(row(i), times(row(j)));
	};
	Quadric placed = *this;
	placed.square_ = {entry(0, 0), entry(1, 1), entry(2, 2)};
	placed.mixed_ = {2.0 * entry(0, 1), 2.0 * entry(0, 2), 2.0 * entry(1, 2)};
	placed.linear_ = frame * linear_;
	placed.origin_ = axes.origin + frame * origin_;
	return placed;
}

Vec3 Quadric::times(const Vec3& q) const
{
	return {square_.x * q.x + 0.5 * (mixed_.x * q.y + mixed_.y * q.z),
	        square_.y * q.y + 0.5 * (mixed_.x * q.x + mixed_.z * q.z),
	        square_.z * q.z + 0.5 * (mixed_.y * q.x + mixed_.z * q.y)};
}

Vec3 Quadric::gradient(const Vec3& p) const
{
	return 2.0 * times(p - origin_) + linear_;
}

double Quadric::crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const
{
	const Vec3 d = b - a;
	const double along = glm::dot(gradient(a), d);
	const double bend = glm::dot(d, times(d));
	// bend t^2 + along t + height_a = 0, of whose two roots one lies between.
	const double root = std::sqrt(std::max(0.0, along * along - 4.0 * bend * height_a));
	const double q = -0.5 * (along + std::copysign(root, along));
	const double far = bend != 0.0 ? q / bend : 2.0;
	const double near = q != 0.0 ? height_a / q : 2.0;
	const auto between = [](double t) { return t >= 0.0 && t <= 1.0; };
	if (between(near) || between(far))
		return between(near) ? near : far;
	// Rounding put both outside: the surface lies at an end.
	return std::abs(height_a) <= std::abs(height_b) ? 0.0 : 1.0;
}

bool Quadric::meets(const Box& box) const
{
	const Vec3 half = 0.5 * box.size();
	const Vec3 center = box.center();
	// The largest difference between heights in the box and the height at the center, beyond the linear part.
	const double bends = glm::dot(half, glm::abs(square_) * half) + std::abs(mixed_.x) * half.x * half.y +
	                     std::abs(mixed_.y) * half.x * half.z + std::abs(mixed_.z) * half.y * half.z;
	const double reach = glm::dot(glm::abs(gradient(center)), half) + bends;
	// Rounding of the height and of the gradient, which are sums of up to ten terms of this size.
	const Vec3 far = glm::abs(center - origin_) + half + 1e-15 * (glm::abs(center) + glm::abs(origin_));
	const double size = glm::dot(far, glm::abs(square_) * far) + std::abs(mixed_.x) * far.x * far.y +
	                    std::abs(mixed_.y) * far.x * far.z + std::abs(mixed_.z) * far.y * far.z +
	                    glm::dot(glm::abs(linear_), far) + std::abs(constant_);
	return std::abs(height(center)) <= reach + 1e-13 * size;
}

} // namespace vp::surface
