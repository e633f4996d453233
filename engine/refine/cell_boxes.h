#pragma once

#include "base/vec.h"
#include "grid/curved/curved_cells.h"
#include "refine/cell_kinds.h"
#include "refine/sheets.h"

#include <cstdint>
#include <vector>

namespace vp::refine
{

/// Cells in boxes of 16 that lie close together. The boxes hold all of the cells, however these are curved.
class CellBoxes
{
public:
	/// Looks at every cell once, on all cores.
	CellBoxes(const grid::CurvedCells& cells, const CellKinds& kinds);

	/// Returns the cells in the boxes that one of the sheets may meet, box by box.
	std::vector<std::uint32_t> cellsNear(const Sheets& sheets) const;

	/// Returns the largest absolute coordinate of a node.
	double reach() const { return reach_; }
	std::size_t bytes() const { return 4 * cells_.capacity() + sizeof(Box) * boxes_.capacity(); }

private:
	std::vector<std::uint32_t> cells_; // along a Morton curve
	std::vector<Box> boxes_;
	double reach_ = 0.0;
};

} // namespace vp::refine
