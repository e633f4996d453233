#pragma once

#include "base/vec.h"
#include "surface/curved.h"
#include "surface/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace vp::refine
{

/// The surfaces that cells are refined along.
struct Sheets
{
	std::vector<surface::Plane> planes;
	std::vector<surface::BlockSurface> others; // with a place: none of values

	/// Returns true if one of them may meet the box.
	bool meet(const Box& box) const
	{
		return std::ranges::any_of(planes, [&](const surface::Plane& plane) { return plane.meets(box); }) ||
		       std::ranges::any_of(others, [&](const surface::BlockSurface& surface) { return surface.meets(box); });
	}
	/// Returns false if none of them meets the convex hull of the points, widened by `margin` all around.
	template <class Points>
	bool meetHull(const Points& points, double margin) const
	{
		const auto isMet = [&](const surface::Plane& plane)
		{
			double lo = std::numeric_limits<double>::infinity();
			double hi = -lo;
			for (const Vec3& point : points)
			{
				const double distance = plane.signedDistance(point);
				lo = std::min(lo, distance);
				hi = std::max(hi, distance);
			}
			return lo <= margin && hi >= -margin;
		};
		if (std::ranges::any_of(planes, isMet))
			return true;
		if (others.empty())
			return false;
		Box box;
		for (const Vec3& point : points)
			box.include(point);
		if (!std::isfinite(margin))
			return true;
		box.lo -= margin;
		box.hi += margin;
		return std::ranges::any_of(others, [&](const surface::BlockSurface& surface) { return surface.meets(box); });
	}
	/// The largest absolute coordinate of where planes begin: what their distances are rounded by.
	double reach() const
	{
		double reach = 0.0;
		for (const surface::Plane& plane : planes)
			reach = std::max(reach, glm::length(plane.origin()));
		return reach;
	}
};

} // namespace vp::refine
