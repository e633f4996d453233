#pragma once

#include "surface/plane.h"
#include "surface/point_heights.h"

namespace vp::surface
{

// S at points, four at a time and in float, where that is certain to be what the one expression in double says
// (Plane::signedDistance).
class SignFilter
{
public:
	static constexpr unsigned kInDoubt = ~0u;

	// bounds: of the points.
	SignFilter(const Plane& plane, const Box& bounds) : heights_(plane.normal(), plane.origin(), bounds) {}

	// Bit v: S at point v. kInDoubt where one of them is to be asked in double.
	unsigned four(const FourPoints& points) const
	{
		const FourFloats height = heights_.at(points);
		if (bitsAtLeast(magnitude(height), FourFloats(heights_.doubt())) != 15)
			return kInDoubt;
		return bitsAtLeast(height, FourFloats(0.0f));
	}

	// S at four times four points: bit 4 v + r is that of point v of points[r]. kInDoubt where one of them is to be
	// asked in double.
	unsigned sixteen(const std::array<FourPoints, 4>& points) const
	{
		const std::array height = {heights_.at(points[0]), heights_.at(points[1]), heights_.at(points[2]),
		                           heights_.at(points[3])};
		// A NaN may get lost here. In double precision it is not positive either.
		const FourFloats least = lesser(lesser(magnitude(height[0]), magnitude(height[1])),
		                                lesser(magnitude(height[2]), magnitude(height[3])));
		if (bitsAtLeast(least, FourFloats(heights_.doubt())) != 15)
			return kInDoubt;
		return bitsAtLeast(height, FourFloats(0.0f));
	}

private:
	PointHeights heights_;
};

} // namespace vp::surface
