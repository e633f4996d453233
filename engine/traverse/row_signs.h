#pragma once

#include "surface/plane.h"
#include "traverse/row_heights.h"

namespace vp::traverse
{

// S at runs of points, four at a time, the same bits as isPositive(): what float leaves in doubt is asked in double.
// Number is what the coordinates are kept as.
template <class Number>
class RowSigns
{
public:
	// bounds: of the points.
	RowSigns(const grid::Points& points, const surface::Plane& plane, const Box& bounds)
	    : points_(points), plane_(plane), xyz_(numbersOf<Number>(points)),
	      heights_(plane.normal(), plane.origin(), bounds)
	{
	}

	// Bit v: S at point p + v, for v < count <= 4. Bits from count on are 0.
	unsigned few(PointId p, unsigned count) const
	{
		unsigned bits = 0;
		for (unsigned v = 0; v < count; ++v)
			bits |= static_cast<unsigned>(plane_.signedDistance(points_[p + v]) >= 0.0) << v;
		return bits;
	}
	// Of the points p to p + 3, which all exist.
	unsigned four(PointId p) const
	{
		const FourFloats height = heights_.at(loadFour(xyz_ + 3 * std::size_t(p)));
		if (bitsAtLeast(magnitude(height), FourFloats(heights_.doubt())) != 15)
			return few(p, 4);
		return bitsAtLeast(height, FourFloats(0.0f));
	}

	void prefetch(PointId from, PointId to) const { points_.prefetch(from, to); }

private:
	const grid::Points& points_;
	const surface::Plane& plane_;
	const Number* xyz_;
	RowHeights heights_;
};

} // namespace vp::traverse
