#pragma once

#include "base/prefetch.h"
#include "grid/points.h"
#include "surface/plane.h"
#include "surface/sign_filter.h"

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

	// S at `count` points of each row from rows[r] on, at most four: bit 4 v + r is that of point rows[r] + v. Bits of
	// further points are 0.
	unsigned columns(const std::array<PointId, 4>& rows, unsigned count) const
	{
		if (count == 4)
		{
			const auto load = [&](PointId p) { return surface::loadFour(xyz_ + 3 * std::size_t(p)); };
			const unsigned bits = filter_.sixteen({load(rows[0]), load(rows[1]), load(rows[2]), load(rows[3])});
			if (bits != surface::SignFilter::kInDoubt) [[likely]]
				return bits;
		}
		return inDouble(rows, count);
	}

	// Fetches the points `from` to `to` in advance.
	void prefetch(PointId from, PointId to) const
	{
		constexpr std::size_t kLine = 64 / sizeof(Number);
		const Number* end = xyz_ + 3 * std::size_t(to) + 2;
		for (const Number* at = xyz_ + 3 * std::size_t(from); at < end; at += kLine)
			vp::prefetch(at);
		vp::prefetch(end);
	}

private:
	[[gnu::noinline]] unsigned inDouble(const std::array<PointId, 4>& rows, unsigned count) const
	{
		unsigned bits = 0;
		for (unsigned v = 0; v < count; ++v)
			for (unsigned r = 0; r < 4; ++r)
				bits |= static_cast<unsigned>(plane_.signedDistance(points_[rows[r] + v]) >= 0.0) << (4 * v + r);
		return bits;
	}

	const grid::Points& points_;
	const surface::Plane& plane_;
	const Number* xyz_;
	surface::SignFilter filter_;
};

} // namespace vp::find
