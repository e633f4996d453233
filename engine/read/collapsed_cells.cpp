#include "read/collapsed_cells.h"

#include "base/parallel_for.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::read
{

namespace
{

using grid::CellShape;
using Corners = std::array<std::int64_t, grid::kMaxShapePoints>;

constexpr int kTetraCorners = 4;

constexpr std::array<std::uint8_t, 8> kOwnOrder{0, 1, 2, 3, 4, 5, 6, 7};

// Which of the four corners stands at each place.
constexpr std::array<std::uint8_t, 8> kHexahedronOrder{0, 1, 2, 2, 3, 3, 3, 3};
constexpr std::array<std::uint8_t, 6> kWedgeOrder{0, 1, 2, 3, 3, 3};
constexpr std::array<std::uint8_t, 5> kPyramidOrder{0, 1, 2, 2, 3};

std::span<const std::uint8_t> tetrahedronOrder(CellShape shape)
{
	if (shape == CellShape::hexahedron)
		return kHexahedronOrder;
	return shape == CellShape::wedge ? std::span<const std::uint8_t>(kWedgeOrder) : kPyramidOrder;
}

// Writes the distinct corners, in the order in which they come first. Returns how many there are.
int distinctCorners(const Corners& corners, std::span<const std::uint8_t> places, Corners& distinct)
{
	int count = 0;
	for (const std::uint8_t place : places)
		if (std::find(distinct.begin(), distinct.begin() + count, corners[place]) == distinct.begin() + count)
			distinct[static_cast<std::size_t>(count++)] = corners[place];
	return count;
}

// Returns true for a cell with four distinct corners of which some face has all.
bool isBentTetrahedron(CellShape shape, const Corners& corners)
{
	const grid::ShapeTopology& table = grid::topology(shape);
	Corners distinct;
	if (distinctCorners(corners, std::span(kOwnOrder).first(static_cast<std::size_t>(table.points)), distinct) !=
	    kTetraCorners)
		return false;
	for (int f = 0; f < table.faces; ++f)
		if (distinctCorners(corners, table.facePoints(f), distinct) == kTetraCorners)
			return true;
	return false;
}

// Returns true if corners are equal that must be equal in a cell with only four different corners, all on one face.
// Such a cell has edges without length along at least two axes, so two axes of a hexahedron are enough to test, the
// triangles of a wedge, and the tip of a pyramid. The tests are written out because for nearly all cells no other test
// follows.
template <class Id>
bool mayBeBent(std::uint8_t type, const Id* p)
{
	const auto alike = [p](int a, int b) { return static_cast<unsigned>(p[a] == p[b]); };
	if (type == grid::kHexahedron)
		return alike(0, 1) | alike(1, 2) | alike(2, 3) | alike(3, 0) | alike(4, 5) | alike(5, 6) | alike(6, 7) |
		       alike(7, 4);
	if (type == grid::kVoxel)
		return alike(0, 1) | alike(1, 3) | alike(3, 2) | alike(2, 0) | alike(4, 5) | alike(5, 7) | alike(7, 6) |
		       alike(6, 4);
	if (type == grid::kWedge)
		return alike(0, 1) | alike(1, 2) | alike(2, 0) | alike(3, 4) | alike(4, 5) | alike(5, 3);
	return alike(0, 4) | alike(1, 4) | alike(2, 4) | alike(3, 4);
}

const std::uint8_t* orderOf(std::uint8_t type)
{
	return type == grid::kVoxel ? grid::kVoxelOrder.data() : kOwnOrder.data();
}

bool canCollapse(std::uint8_t type)
{
	return type == grid::kHexahedron || type == grid::kVoxel || type == grid::kWedge || type == grid::kPyramid;
}

template <class Id>
Corners cornersOfCell(const grid::CellList& cells, std::size_t cell, std::span<const Id> ids)
{
	Corners corners{};
	const std::uint8_t* order = orderOf(cells.types[cell]);
	for (int i = 0; i < grid::topology(grid::shapeOf(cells.types[cell])).points; ++i)
		corners[static_cast<std::size_t>(i)] = ids[cells.start(cell) + order[i]];
	return corners;
}

template <class Id>
bool isBent(const grid::CellList& cells, std::size_t cell, std::span<const Id> ids)
{
	const std::uint8_t type = cells.types[cell];
	return canCollapse(type) && mayBeBent(type, ids.data() + cells.start(cell)) &&
	       isBentTetrahedron(grid::shapeOf(type), cornersOfCell(cells, cell, ids));
}

// Brings the corners of such a cell into the order in which its faces are those of the tetrahedron.
template <class Id>
void orderCell(const grid::CellList& cells, std::size_t cell, std::span<Id> ids)
{
	const CellShape shape = grid::shapeOf(cells.types[cell]);
	const std::span places = std::span(kOwnOrder).first(static_cast<std::size_t>(grid::topology(shape).points));
	Corners distinct{};
	distinctCorners(cornersOfCell(cells, cell, std::span<const Id>(ids)), places, distinct);
	for (const std::uint8_t place : places)
		ids[cells.start(cell) + orderOf(cells.types[cell])[place]] =
		    static_cast<Id>(distinct[tetrahedronOrder(shape)[place]]);
}

template <class Id>
std::vector<std::size_t> bentTetrahedra(const grid::CellList& cells, std::span<const Id> ids)
{
	tbb::combinable<std::vector<std::size_t>> found;
	parallelFor(tbb::blocked_range<std::size_t>(0, cells.size(), 1 << 14),
	            [&](const auto& range)
	            {
		            for (std::size_t c = range.begin(); c < range.end(); ++c)
		            {
			            if (isBent(cells, c, ids))
				            found.local().push_back(c);
		            }
	            });
	std::vector<std::size_t> all;
	found.combine_each([&](const auto& some) { all.insert(all.end(), some.begin(), some.end()); });
	return all;
}

} // namespace

void orderCollapsed(grid::CellList& cells)
{
	// Mostly all cells are of one type. Then the first tells, and if it is a tetrahedron nothing else is asked.
	if (cells.offsets.empty() && !canCollapse(cells.types[0]))
		return;
	const auto ordered = [&]<class Id>(std::span<const Id> ids)
	{
		const std::vector<std::size_t> bent = bentTetrahedra(cells, ids);
		if (bent.empty())
			return grid::IdArray();
		std::vector<Id> copy(ids.begin(), ids.end());
		for (const std::size_t cell : bent)
			orderCell(cells, cell, std::span(copy));
		return grid::IdArray(std::move(copy));
	};
	if (grid::IdArray made = cells.connectivity.as(ordered); made.size() > 0)
		cells.connectivity = std::move(made);
}

void orderCollapsed(const grid::CellList& cells, std::size_t begin, std::size_t end, std::span<std::int32_t> ids)
{
	for (std::size_t c = begin; c < end; ++c)
		if (isBent(cells, c, std::span<const std::int32_t>(ids)))
			orderCell(cells, c, ids);
}

} // namespace vp::read
