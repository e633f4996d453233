#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"

#include <cstddef>

namespace vp::locate
{

// The cell of a block that contains a point, and the cost of the search.
struct Located
{
	CellId cell = kNoCell; // kNoCell: the point is outside the block
	std::size_t hops = 0;
	std::size_t boundary_tests = 0;

	bool found() const { return cell != kNoCell; }
};

// Finds the cell by fence hopping from `start` (kNoCell: from the vantage point nearest to the target). If the line of
// sight leaves the grid, or hops go in a circle, it starts again from the vantage points, the nearest to the target
// first, for at most 4 N^(1/3) hops in total. After that the boundary decides. Among the boundary faces on the shortest
// way out of the bounds, the nearest one is in sight of the target. If the target is inside, the cell behind that face
// leads to it.
Located findCell(const grid::Block& block, CellId start, const Vec3& target);

} // namespace vp::locate
