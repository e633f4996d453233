#pragma once

#include "base/select.h"
#include "base/vec.h"

#include <algorithm>
#include <cmath>

namespace vp::surface
{

// The plane through `origin` with unit normal. S(x) = 1 where signedDistance(x) >= 0: a vertex on the plane counts as
// positive. The normal is canonical (its first nonzero component is positive), so that a plane and its flip cut alike.
//
// The sign of a vertex is this one expression in double, the same for every cell around it; the build forbids fused
// multiply-add for that reason.
class Plane
{
public:
	// `normal` of any length but zero.
	Plane(const Vec3& origin, const Vec3& normal);

	const Vec3& origin() const { return origin_; }
	const Vec3& normal() const { return normal_; }

	double signedDistance(const Vec3& p) const { return glm::dot(normal_, p - origin_); }

	// Whether the plane may pass through the box, its rim included.
	bool meets(const Box& box) const
	{
		const Vec3 half = 0.5 * box.size();
		const double reach = glm::dot(glm::abs(normal_), half);
		// Rounding of center and half size, so that no face is lost that touches the box's side.
		const Vec3 reaches = glm::abs(box.lo) + glm::abs(box.hi) + glm::abs(origin_);
		const double slack = 1e-14 * (reaches.x + reaches.y + reaches.z);
		return std::abs(signedDistance(box.center())) <= reach + slack;
	}

	/// How far from a to b an edge meets the plane, 0 to 1, by the distances of its ends, of which one is negative.
	/// From b to a it is the rest: neither says that it is at an end where the other does not.
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
