#include "locate/place.h"

#include "locate/find_cell.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vp::locate
{

namespace
{

// In the cell's own coordinates.
constexpr double kHeld = -1e-9; // rounding: a cell still contains a point this far outside
constexpr double kAlone = 1e-6; // no other cell contains a point this deep inside

// Returns the cell's rank in the file's order. Linear cells that were cut from one curved cell share its number.
std::pair<std::int64_t, CellId> rank(const grid::Block& block, CellId cell)
{
	return {grid::cellNumber(block, cell), cell};
}

bool holds(const Box& box, const Vec3& point)
{
	return glm::all(glm::lessThanEqual(box.lo, point)) && glm::all(glm::lessThanEqual(point, box.hi));
}

Box widened(const Box& box)
{
	const Vec3 margin(1e-9 * box.diagonal()); // rounding
	return {box.lo - margin, box.hi + margin};
}

Box boxOf(const grid::Block& block, CellId cell)
{
	return std::visit(
	    [&](const auto& grid)
	    {
		    Box box;
		    if (grid.shape(cell) != grid::CellShape::polyhedron)
		    {
			    for (const PointId p : grid.cellPoints(cell))
				    box.include(grid.point(p));
			    return box;
		    }
		    grid::CellFaces faces;
		    grid.cellFaces(cell, faces);
		    for (const PointId p : faces.points)
			    box.include(grid.point(p));
		    return box;
	    },
	    block.grid);
}

template <class Visit>
void forEachNeighbor(const grid::Block& block, CellId cell, Visit&& visit)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    for (int f = 0; f < grid.faceCount(cell); ++f)
			    grid.forEachNeighbor(cell, f, visit);
	    },
	    block.grid);
}

} // namespace

PlaceFinder::PlaceFinder(const grid::BlockSet& blocks) : blocks_(blocks), last_(blocks.blocks.size(), kNoCell) {}

const Place& PlaceFinder::find(const Vec3& point)
{
	for (std::uint32_t b = 0; b < blocks_.blocks.size(); ++b)
		if (findIn(b, point))
			return place_;
	place_.cell = kNoCell;
	return place_;
}

const Place& PlaceFinder::findByTree(std::uint32_t block, const Vec3& point)
{
	place_.block = block;
	place_.cell = kNoCell;
	if (holds(widened(blocks_.blocks[block].bounds), point))
		searchTree(point);
	return place_;
}

const Place& PlaceFinder::findAtBoundary(std::uint32_t b, const Vec3& point, double reach, CellId besides)
{
	const grid::Block& block = blocks_.blocks[b];
	place_.block = b;
	place_.cell = kNoCell;
	block.boundary.visitWhere(
	    [&](const Box& box) {
		    return !place_.found() && holds({box.lo - reach, box.hi + reach}, point);
	    },
	    [&](const grid::BoundaryIndex::Face& face)
	    {
		    if (place_.found() || face.cell == besides || !holds(widened(boxOf(block, face.cell)), point))
			    return;
		    weigh(face.cell, point);
		    if (place_.weights.depth < kHeld)
			    place_.cell = kNoCell;
	    });
	return place_;
}

void PlaceFinder::weigh(CellId cell, const Vec3& point)
{
	place_.cell = cell;
	weighCell(blocks_.blocks[place_.block], cell, point, place_.weights);
}

bool PlaceFinder::findIn(std::uint32_t b, const Vec3& point)
{
	const grid::Block& block = blocks_.blocks[b];
	place_.block = b;
	if (block.vantage.empty() || !holds(widened(block.bounds), point))
		return false;
	const Located located = findCell(block, last_[b], point);
	if (located.found())
		weigh(located.cell, point);
	if (!located.found() || place_.weights.depth < kHeld)
		searchTree(point);
	else if (place_.weights.depth < kAlone)
		takeFirstOfThoseAround(point);
	if (place_.found())
		last_[b] = place_.cell;
	return place_.found();
}

// Takes the first of the cells that contain the point, going from one to the next.
void PlaceFinder::takeFirstOfThoseAround(const Vec3& point)
{
	const grid::Block& block = blocks_.blocks[place_.block];
	std::vector<CellId> seen{place_.cell};
	std::vector<CellId> around{place_.cell};
	CellWeights weights;
	for (std::size_t next = 0; next < around.size(); ++next)
		forEachNeighbor(block, around[next],
		                [&](CellId neighbor)
		                {
			                if (std::ranges::find(seen, neighbor) != seen.end())
				                return;
			                seen.push_back(neighbor);
			                weighCell(block, neighbor, point, weights);
			                if (weights.depth >= kHeld)
				                around.push_back(neighbor);
		                });
	weigh(*std::ranges::min_element(around, {}, [&](CellId cell) { return rank(block, cell); }), point);
}

void PlaceFinder::searchTree(const Vec3& point)
{
	const grid::Block& block = blocks_.blocks[place_.block];
	CellWeights weights;
	const auto firstBy = [&](const auto& weighIn)
	{
		CellId first = kNoCell;
		grid::treeOf(block).visitWhere([&](const Box& box) { return holds(widened(box), point); },
		                               [&](CellId cell)
		                               {
			                               if (!holds(widened(boxOf(block, cell)), point))
				                               return;
			                               weighIn(block, cell, point, weights);
			                               if (weights.depth >= kHeld &&
			                                   (first == kNoCell || rank(block, cell) < rank(block, first)))
				                               first = cell;
		                               });
		return first;
	};
	place_.cell = firstBy(weighCell);
	if (place_.found())
		return weigh(place_.cell, point);
	// Cells of different shapes may part on a warped face; taken as tetrahedra, all fill it alike.
	place_.cell = firstBy(weighCellByTetrahedra);
	if (place_.found())
		weighCellByTetrahedra(block, place_.cell, point, place_.weights);
}

} // namespace vp::locate
