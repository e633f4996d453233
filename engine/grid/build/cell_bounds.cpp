#include "grid/build/cell_bounds.h"

#include "base/huge_vector.h"
#include "grid/build/for_ranges.h"

#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace vp::grid
{

namespace
{

constexpr std::size_t kGrain = 65536;
constexpr std::size_t kNone = ~std::size_t(0);

/// A box, and for each of its sides (low x, high x, low y …) the first point that lies on it.
struct Extremes
{
	Box box;
	std::array<std::size_t, 6> at{kNone, kNone, kNone, kNone, kNone, kNone};

	void include(const Vec3& x, std::size_t point)
	{
		for (int axis = 0; axis < 3; ++axis)
		{
			if (x[axis] < box.lo[axis])
				at[2 * axis] = point;
			if (x[axis] > box.hi[axis])
				at[2 * axis + 1] = point;
		}
		box.include(x);
	}
	void include(const Extremes& other)
	{
		for (int axis = 0; axis < 3; ++axis)
		{
			if (other.box.lo[axis] < box.lo[axis])
				at[2 * axis] = other.at[2 * axis];
			if (other.box.hi[axis] > box.hi[axis])
				at[2 * axis + 1] = other.at[2 * axis + 1];
		}
		box.include(other.box);
	}
};

bool isFinite(const Vec3& x)
{
	return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

/// Of the points for which takes(p) holds.
template <class Takes>
Extremes extremesOf(const Points& points, const Takes& takes)
{
	return tbb::parallel_reduce(
	    tbb::blocked_range<std::size_t>(0, points.size(), kGrain), Extremes{},
	    [&](const tbb::blocked_range<std::size_t>& range, Extremes extremes)
	    {
		    for (std::size_t p = range.begin(); p < range.end(); ++p)
			    if (const Vec3 x = points[p]; isFinite(x) && takes(p))
				    extremes.include(x, p);
		    return extremes;
	    },
	    [](Extremes a, const Extremes& b)
	    {
		    a.include(b);
		    return a;
	    });
}

/// Whether some cell has the point. Cells are asked outwards from where they would be, were cells and points in the
/// same order: where the point is in use, it is mostly found at once.
bool isUsed(const CellList& cells, std::size_t points, std::size_t point)
{
	const std::size_t count = cells.size();
	const auto has = [&](std::size_t cell)
	{
		bool found = false;
		if (isSliceable(cells.types[cell]))
			cells.forEachPoint(cell, [&](std::int64_t p) { found |= static_cast<std::size_t>(p) == point; });
		return found;
	};
	const auto middle =
	    static_cast<std::size_t>(static_cast<double>(point) / static_cast<double>(points) * static_cast<double>(count));
	// Beyond this it takes longer than to mark all points.
	const std::size_t reach = std::min<std::size_t>(count, count / 16 + kGrain);
	for (std::size_t away = 0; away < reach; ++away)
		if ((middle + away < count && has(middle + away)) || (away < middle && has(middle - away - 1)))
			return true;
	return false;
}

/// A byte for each point: whether a cell has it.
HugeVector<std::uint8_t> usedPoints(const CellList& cells, std::size_t points)
{
	HugeVector<std::uint8_t> used(points);
	forRanges(points, [&](std::size_t p) { used[p] = 0; });
	forRanges(cells.size(),
	          [&](std::size_t c)
	          {
		          if (isSliceable(cells.types[c]))
			          cells.forEachPoint(c, [&](std::int64_t p)
			                             { std::atomic_ref(used[p]).store(1, std::memory_order_relaxed); });
	          });
	return used;
}

} // namespace

Box boundsOfCells(const Points& points, const CellList& cells)
{
	const Extremes all = extremesOf(points, [](std::size_t) { return true; });
	const bool is_right = std::ranges::all_of(all.at, [&](std::size_t point)
	                                          { return point == kNone || isUsed(cells, points.size(), point); });
	if (is_right)
		return all.box;
	const HugeVector<std::uint8_t> used = usedPoints(cells, points.size());
	return extremesOf(points, [&](std::size_t p) { return used[p] != 0; }).box;
}

} // namespace vp::grid
