#include "locate/find_cell.h"

#include "locate/fence_hop.h"
#include "locate/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vp::locate
{

namespace
{

// The cells behind the boundary faces that the segment crosses first: one, or several where faces lie on each other.
template <grid::Grid G>
std::vector<CellId> cellsInSight(const G& grid, const grid::BoundaryIndex& boundary, const Segment& segment,
                                 std::size_t& tests)
{
	constexpr double kSame = 1e-9; // along the segment
	double first = kNoCrossing;
	std::vector<CellId> cells;
	grid::CellFaces faces;
	const auto visit = [&](const grid::BoundaryIndex::Face& face)
	{
		++tests;
		grid.cellFaces(face.cell, faces);
		const std::span<const PointId> points = faces[face.face];
		// About the mean of its points, so that a warped face has no gap to its neighbors.
		const Vec3 center = facePlane(grid, points).center;
		double nearest = kNoCrossing;
		Vec3 previous = grid.point(points.back());
		for (const PointId p : points)
		{
			const Vec3 corner = grid.point(p);
			nearest = std::min(nearest, crossTriangle(segment, center, previous, corner));
			previous = corner;
		}
		if (nearest == kNoCrossing || nearest > first + kSame)
			return;
		if (nearest < first - kSame)
			cells.clear();
		cells.push_back(face.cell);
		first = std::min(first, nearest);
	};
	tests += boundary.visitWhere([&](const Box& box) { return crossesBox(segment, box); }, visit);
	return cells;
}

// From the target out of the bounds by the shortest way, a little askew: along an axis it would run in the faces of a
// lattice.
Segment wayOut(const Vec3& target, const Box& bounds)
{
	const double beyond = 0.01 * bounds.diagonal();
	Segment way{target, target};
	double shortest = std::numeric_limits<double>::infinity();
	for (int axis = 0; axis < 3; ++axis)
		for (const double side : {bounds.lo[axis] - beyond, bounds.hi[axis] + beyond})
			if (const double length = std::abs(side - target[axis]); length < shortest)
			{
				shortest = length;
				way.to = target + shortest * Vec3(0.031, 0.017, 0.023);
				way.to[axis] = side;
			}
	return way;
}

template <grid::Grid G>
Located find(const G& grid, const grid::Block& block, CellId start, const Vec3& target)
{
	Located located;
	const double side = std::cbrt(static_cast<double>(grid.cellCount()));
	// A search may cost 6 N^(1/3) hops. The rest is kept for the way that the boundary shows.
	const auto budget = static_cast<std::size_t>(4.0 * side);
	const auto hopFrom = [&](CellId from, std::size_t most)
	{
		const Hop hop = fenceHop(grid, from, target, most);
		located.hops += hop.hops;
		if (hop.end == Hop::End::found)
			located.cell = hop.cell;
		return located.found();
	};

	std::vector<std::pair<double, CellId>> starts;
	for (const CellId cell : block.vantage)
		if (cell != start)
			starts.emplace_back(glm::length(cellCenter(grid, cell) - target), cell);
	if (start != kNoCell)
		starts.emplace_back(-1.0, start);
	std::sort(starts.begin(), starts.end());
	for (const auto& [distance, cell] : starts)
	{
		if (located.hops >= budget)
			break;
		if (hopFrom(cell, budget - located.hops))
			return located;
	}

	for (const CellId cell : cellsInSight(grid, block.boundary, wayOut(target, block.bounds), located.boundary_tests))
		if (hopFrom(cell, budget))
			break;
	return located;
}

} // namespace

Located findCell(const grid::Block& block, CellId start, const Vec3& target)
{
	const double slack = 1e-12 * block.bounds.diagonal();
	const bool in_bounds = glm::all(glm::greaterThanEqual(target, block.bounds.lo - slack)) &&
	                       glm::all(glm::lessThanEqual(target, block.bounds.hi + slack));
	if (!in_bounds || (start == kNoCell && block.vantage.empty()))
		return {};
	return std::visit([&](const auto& grid) { return find(grid, block, start, target); }, block.grid);
}

} // namespace vp::locate
