#pragma once

#include "base/vec.h"

#include <cmath>

namespace vp::locate
{

struct Segment
{
	Vec3 from;
	Vec3 to;
};

constexpr double kNoCrossing = 2.0; // beyond the end of the segment at t = 1

// Returns true if the segment touches the box (by slabs, with a slack for rounding).
inline bool crossesBox(const Segment& segment, const Box& box)
{
	const Vec3 along = segment.to - segment.from;
	const double slack = 1e-12 * (glm::length(box.size()) + glm::length(along));
	double enter = 0.0;
	double leave = 1.0;
	for (int axis = 0; axis < 3; ++axis)
	{
		const double lo = box.lo[axis] - slack - segment.from[axis];
		const double hi = box.hi[axis] + slack - segment.from[axis];
		if (along[axis] == 0.0)
		{
			if (lo > 0.0 || hi < 0.0)
				return false;
			continue;
		}
		const double a = lo / along[axis];
		const double b = hi / along[axis];
		enter = std::max(enter, std::min(a, b));
		leave = std::min(leave, std::max(a, b));
	}
	return enter <= leave;
}

// Returns t in 0..1 where the segment meets the triangle, or kNoCrossing. See Moeller and Trumbore, "Fast, Minimum
// Storage Ray/Triangle Intersection" (1997). The rim belongs to the triangle, with a slack of 1e-9, so a line through a
// shared edge meets one of the two triangles.
inline double crossTriangle(const Segment& segment, const Vec3& a, const Vec3& b, const Vec3& c)
{
	const Vec3 along = segment.to - segment.from;
	const Vec3 ab = b - a;
	const Vec3 ac = c - a;
	const Vec3 p = glm::cross(along, ac);
	const double determinant = glm::dot(ab, p);
	if (determinant == 0.0)
		return kNoCrossing;
	const Vec3 s = segment.from - a;
	const double u = glm::dot(s, p) / determinant;
	const Vec3 q = glm::cross(s, ab);
	const double v = glm::dot(along, q) / determinant;
	const double t = glm::dot(ac, q) / determinant;
	constexpr double kSlack = 1e-9;
	const bool inside = u >= -kSlack && v >= -kSlack && u + v <= 1.0 + kSlack && t >= 0.0 && t <= 1.0;
	return inside ? t : kNoCrossing;
}

} // namespace vp::locate
