#pragma once

#include "find/sign_filter.h"
#include "grid/points.h"
#include "surface/plane.h"

namespace vp::find
{

// S at runs of points, four at a time, the same bits as isPositive(): what float leaves in doubt is asked in double.
// Number is what the coordinates are kept as.
template <class Number>
class RowSigns
{
public:
	// bounds: of the points.
	RowSigns(const grid::Points& points, const surface::Plane& plane, const Box& bounds)
	    : points_(points), plane_(plane), xyz_(points.numbers<Number>()), filter_(plane, bounds)
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
		const unsigned bits = filter_.four(loadFour(xyz_ + 3 * std::size_t(p)));
		return bits == SignFilter::kInDoubt ? few(p, 4) : bits;
	}

	// Of the points rows[r] to rows[r] + 3, bits[r] as four() gives them.
	std::array<unsigned, 4> sixteen(const std::array<PointId, 4>& rows) const
	{
		const auto load = [&](PointId p) { return loadFour(xyz_ + 3 * std::size_t(p)); };
		std::array<unsigned, 4> bits;
		if (!filter_.sixteen({load(rows[0]), load(rows[1]), load(rows[2]), load(rows[3])}, bits))
			for (std::size_t r = 0; r < rows.size(); ++r)
				bits[r] = four(rows[r]);
		return bits;
	}

	void prefetch(PointId from, PointId to) const { points_.prefetch(from, to); }

private:
	const grid::Points& points_;
	const surface::Plane& plane_;
	const Number* xyz_;
	SignFilter filter_;
};

} // namespace vp::find
