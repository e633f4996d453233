#include "locate/find_cell.h"

#include "locate/fence_hop.h"
#include "locate/segment.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vp::locate
{

namespace
{

struct Crossing
{
	CellId cell = kNoCell;
	double t = 2.0; // along the segment; beyond its end until a face is crossed
};

// The boundary face that the segment from `from` to `to` crosses first.
template <grid::Grid G>
Crossing firstBoundaryCrossing(const G& grid, const grid::BoundaryIndex& boundary, const Segment& segment,
							   std::size_t& tests)
{
	Crossing first;
	grid::CellFaces faces;
	const auto visit = [&](const grid::BoundaryIndex::Face& face)
	{
		++tests;
		grid.cellFaces(face.cell, faces);
		const std::span<const PointId> points = faces[face.face];
		// About the mean of its points, so that a warped face has no gap to its neighbours.
		const Vec3 centre = facePlane(grid, points).centre;
		Vec3 previous = grid.point(points.back());
		for (const PointId p : points)
		{
			const Vec3 corner = grid.point(p);
			if (const double t = crossTriangle(segment, centre, previous, corner); t < first.t)
				first = {face.cell, t};
			previous = corner;
		}
	};
	tests += boundary.visitWhere([&](const Box& box) { return crossesBox(segment, box); }, visit);
	return first;
}

template <grid::Grid G>
Located find(const G& grid, const grid::Block& block, CellId start, const Vec3& target)
{
	Located located;
	const double side = std::cbrt(static_cast<double>(grid.cellCount()));
	const auto budget = static_cast<std::size_t>(6.0 * side) + 8;
	const auto hopFrom = [&](CellId from)
	{
		const Hop hop = fenceHop(grid, from, target, budget);
		located.hops += hop.hops;
		if (hop.end == Hop::End::found)
			located.cell = hop.cell;
		return located.found();
	};
	if (hopFrom(start))
		return located;

	std::vector<std::pair<double, CellId>> vantage;
	for (const CellId cell : block.vantage)
		if (cell != start)
			vantage.emplace_back(glm::length(cellCentre(grid, cell) - target), cell);
	std::sort(vantage.begin(), vantage.end());
	for (const auto& [distance, cell] : vantage)
	{
		if (located.hops > budget)
			break;
		if (hopFrom(cell))
			return located;
	}

	const Segment segment{target, cellCentre(grid, start)};
	const Crossing crossing = firstBoundaryCrossing(grid, block.boundary, segment, located.boundary_tests);
	if (crossing.cell != kNoCell)
		hopFrom(crossing.cell);
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
	return std::visit([&](const auto& grid) { return find(grid, block, start == kNoCell ? block.vantage.front() : start, target); },
					  block.grid);
}

} // namespace vp::locate
