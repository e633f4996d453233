#pragma once

#include "base/vec.h"
#include "grid/curved_cells.h"
#include "surface/plane.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::refine
{

/// Cells in boxes of 16 that lie close together. The boxes hold all of the cells, however these are curved.
class CellBoxes
{
public:
	/// Looks at every cell once, on all cores.
	explicit CellBoxes(const grid::CurvedCells& cells);

	/// Returns the cells in the boxes that one of the planes meets, box by box.
	std::vector<std::uint32_t> cellsNear(std::span<const surface::Plane> planes) const;

	/// Returns the largest absolute coordinate of a node.
	double reach() const { return reach_; }
	std::size_t bytes() const { return 4 * cells_.capacity() + sizeof(Box) * boxes_.capacity(); }

private:
	std::vector<std::uint32_t> cells_; // along a Morton curve
	std::vector<Box> boxes_;
	double reach_ = 0.0;
};

} // namespace vp::refine
