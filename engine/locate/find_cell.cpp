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
	CellId cell;
	double t; // along the segment
};

// Faces that coincide at a seam are crossed at the same t, but for rounding; the target is behind one of them.
constexpr double kSameCrossing = 1e-9;
constexpr std::size_t kMostAtOneCrossing = 4;

constexpr int kMostRounds = 2; // of asking the boundary

// The boundary faces that the segment crosses first: one, or those that coincide there.
template <grid::Grid G>
std::vector<Crossing> firstBoundaryCrossings(const G& grid, const grid::BoundaryIndex& boundary, const Segment& segment,
											 std::size_t& tests)
{
	std::vector<Crossing> first;
	const auto keep = [&](const Crossing& crossing)
	{
		if (!first.empty() && crossing.t > first.front().t + kSameCrossing)
			return;
		const auto at = std::ranges::upper_bound(first, crossing.t, {}, &Crossing::t);
		first.insert(at, crossing);
		while (first.size() > kMostAtOneCrossing || first.back().t > first.front().t + kSameCrossing)
			first.pop_back();
	};
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
			if (const double t = crossTriangle(segment, centre, previous, corner); t != kNoCrossing)
				keep({face.cell, t});
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
	CellId reached = start;
	const auto hopFrom = [&](CellId from)
	{
		const Hop hop = fenceHop(grid, from, target, budget);
		located.hops += hop.hops;
		reached = hop.cell;
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

	// The point of crossing is in sight of the target, the centre of its cell nearly always: if not, the hop came nearer.
	CellId from = start;
	for (int round = 0; round < kMostRounds; ++round)
	{
		const Segment segment{target, cellCentre(grid, from)};
		for (const Crossing& crossing : firstBoundaryCrossings(grid, block.boundary, segment, located.boundary_tests))
			if (hopFrom(crossing.cell))
				return located;
		if (reached == from)
			break;
		from = reached;
	}
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
