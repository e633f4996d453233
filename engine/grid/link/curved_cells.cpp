#include "grid/curved/curved_cells.h"
#include "base/parallel_reduce.h"

#include "grid/link/for_ranges.h"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace vp::grid
{

namespace
{

/// The same cells without the nodes between their corners.
template <class Id>
CellList cornersOf(const CurvedCells& curved, std::span<const Id> nodes)
{
	const std::size_t count = curved.cells.size();
	std::vector<std::uint8_t> types(count);
	std::vector<std::int64_t> offsets(count + 1);
	for (std::size_t c = 0; c < count; ++c)
	{
		types[c] = curved.isCurved(c) ? linearType(cornerShape(curved.cells.types[c])) : curved.cells.types[c];
		offsets[c + 1] = offsets[c] + (isSliceable(types[c]) ? topology(shapeOf(types[c])).points : 0);
	}
	std::vector<Id> corners(static_cast<std::size_t>(offsets[count]));
	forRanges(count,
	          [&](std::size_t c)
	          {
		          std::copy_n(nodes.begin() + static_cast<std::ptrdiff_t>(curved.start(c)), offsets[c + 1] - offsets[c],
		                      corners.begin() + offsets[c]);
	          });
	CellList list;
	list.types = Array(std::move(types));
	list.offsets = Array(std::move(offsets));
	list.connectivity = std::move(corners);
	return list;
}

/// Returns the bounds of the nodes between corners.
Box boundsOfMiddles(const CurvedCells& curved)
{
	return parallelReduce(
	    curved.cells.size(), 4096, Box(),
	    [&](const tbb::blocked_range<std::size_t>& range, Box box)
	    {
		    for (std::size_t c = range.begin(); c < range.end(); ++c)
			    if (curved.isCurved(c))
				    for (std::size_t n = 4; n < curved.nodes(c); ++n)
					    box.include(curved.points[curved.node(c, n)]);
		    return box;
	    },
	    [](Box a, const Box& b)
	    {
		    a.include(b);
		    return a;
	    });
}

} // namespace

std::array<int, 3> CurvedCells::degreesOf(std::size_t cell) const
{
	const std::uint8_t type = cells.types[cell];
	const bool is_tetrahedron = cornerShape(type) == CellShape::tetrahedron;
	if (hasMiddles(type, nodes(cell)))
		return {2, 2, 2};
	if (!degrees.empty() && !is_tetrahedron)
		return {degrees[3 * cell], degrees[3 * cell + 1], degrees[3 * cell + 2]};
	const int degree = degreeOf(type, nodes(cell)).value_or(0);
	return {degree, degree, degree};
}

void takeCurvedCells(Block& block, CurvedCells curved)
{
	CellList corners = curved.cells.connectivity.as([&](auto nodes) { return cornersOf(curved, nodes); });
	block.grid = UnstructuredGrid::listed(curved.points, std::move(corners));
	finishBlock(block);
	block.bounds.include(boundsOfMiddles(curved));
	block.curved = std::make_shared<const CurvedCells>(std::move(curved));
}

} // namespace vp::grid
