#include "grid/link/cell_bounds.h"

#include "base/huge_vector.h"
#include "base/parallel_for.h"
#include "grid/link/for_ranges.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

namespace vp::grid
{

namespace
{

constexpr std::size_t kGrain = 65536;
constexpr std::size_t kNone = ~std::size_t(0);

bool isFinite(const Vec3& x)
{
	return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

/// Returns the bounds of the points in [begin, end) for which takes(p) holds and whose coordinates are finite.
template <class Takes>
Box boxOf(const Points& points, std::size_t begin, std::size_t end, const Takes& takes)
{
	Box box;
	for (std::size_t p = begin; p < end; ++p)
		if (const Vec3 x = points[p]; isFinite(x) && takes(p))
			box.include(x);
	return box;
}

/// The same for all of them, in a loop that the compiler makes into vector instructions.
template <class Number>
Box boxOf(const Points& points, const Number* xyz, std::size_t begin, std::size_t end)
{
	constexpr std::size_t kLanes = 12; // a multiple of three
	std::array<Number, kLanes> lo;
	std::array<Number, kLanes> hi;
	std::array<Number, kLanes> strange{}; // NaN once a coordinate is infinite or NaN
	lo.fill(std::numeric_limits<Number>::infinity());
	hi.fill(-std::numeric_limits<Number>::infinity());
	const std::size_t last = 3 * end;
	std::size_t i = 3 * begin;
	for (; i + kLanes <= last; i += kLanes)
		for (std::size_t lane = 0; lane < kLanes; ++lane)
		{
			const Number x = xyz[i + lane];
			lo[lane] = x < lo[lane] ? x : lo[lane];
			hi[lane] = x > hi[lane] ? x : hi[lane];
			strange[lane] += x * Number(0);
		}
	const auto all = [](std::size_t) { return true; };
	if (std::ranges::any_of(strange, [](Number x) { return x != Number(0); }))
		return boxOf(points, begin, end, all);
	Box box = boxOf(points, i / 3, end, all);
	for (std::size_t lane = 0; lane < kLanes && i > 3 * begin; ++lane)
	{
		double& low = box.lo[static_cast<int>(lane % 3)];
		double& high = box.hi[static_cast<int>(lane % 3)];
		low = std::min<double>(low, lo[lane]);
		high = std::max<double>(high, hi[lane]);
	}
	return box;
}

/// Per part of so many points.
std::vector<Box> boxesOf(const Points& points, std::size_t count)
{
	std::vector<Box> boxes((count + kGrain - 1) / kGrain);
	parallelFor(std::size_t(0), boxes.size(),
	            [&](std::size_t part)
	            {
		            const std::size_t begin = part * kGrain;
		            const std::size_t end = std::min(begin + kGrain, count);
		            boxes[part] = points.isDouble() ? boxOf(points, points.doubles(), begin, end)
		                                            : boxOf(points, points.floats(), begin, end);
	            });
	return boxes;
}

/// The first point that lies on a side of the bounds of all: low or high along an axis.
std::size_t pointOnSide(const Points& points, const std::vector<Box>& boxes, int axis, bool high, double bound)
{
	for (std::size_t part = 0; part < boxes.size(); ++part)
	{
		if ((high ? boxes[part].hi : boxes[part].lo)[axis] != bound)
			continue;
		for (std::size_t p = part * kGrain; p < std::min((part + 1) * kGrain, points.size()); ++p)
			if (const Vec3 x = points[p]; x[axis] == bound && isFinite(x))
				return p;
	}
	return kNone;
}

/// Returns true if some cell has the point. The search starts at the cell that would have the point if cells and points
/// had the same order. So a point that is used is mostly found at once.
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

Box boundsOfPoints(const Points& points, std::size_t count)
{
	Box all;
	for (const Box& box : boxesOf(points, count))
		all.include(box);
	return all;
}

Box boundsOfCells(const Points& points, const CellList& cells)
{
	const std::vector<Box> boxes = boxesOf(points, points.size());
	Box all;
	for (const Box& box : boxes)
		all.include(box);
	bool is_right = true;
	for (int side = 0; side < 6 && is_right; ++side)
	{
		const bool high = side % 2 != 0;
		const std::size_t point = pointOnSide(points, boxes, side / 2, high, (high ? all.hi : all.lo)[side / 2]);
		is_right = point == kNone || isUsed(cells, points.size(), point);
	}
	if (is_right)
		return all;
	if (!cells.has_checked_ids)
		checkIds(cells.connectivity, points.size());
	const HugeVector<std::uint8_t> used = usedPoints(cells, points.size());
	return boxOf(points, 0, points.size(), [&](std::size_t p) { return used[p] != 0; });
}

} // namespace vp::grid
