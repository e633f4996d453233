#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"

#include <cstddef>

namespace vp::locate
{

// The cell of a block that holds a point, and what the search cost.
struct Located
{
	CellId cell = kNoCell; // kNoCell: the point is outside the block
	std::size_t hops = 0;
	std::size_t boundary_tests = 0;

	bool found() const { return cell != kNoCell; }
};

// Fence hopping from `start` (kNoCell: from the vantage point nearest to the target). When the line of sight leaves the
// grid, or hops go in a circle, it starts over from the vantage points, those nearest to the target first, for at most
// 4 N^(1/3) hops in all. The boundary decides what is left: of the boundary faces on the shortest way out of the
// bounds, the one nearest to the target is in sight of it; if the target is inside, the cell behind that face leads to
// it.
Located findCell(const grid::Block& block, CellId start, const Vec3& target);

} // namespace vp::locate
