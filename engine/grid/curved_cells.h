#pragma once

#include "grid/block.h"
#include "grid/cell_list.h"
#include "grid/points.h"

#include <cstddef>
#include <cstdint>

namespace vp::grid
{

inline constexpr std::uint8_t kQuadraticTetra = 24;
inline constexpr std::uint8_t kLagrangeTetra = 71; // with 10 nodes, the same as a quadratic one
inline constexpr int kQuadraticTetraNodes = 10;

/// Cells with nodes on their edges, as a file lists them, beside linear cells. A cut refines those that it meets.
struct CurvedCells
{
	Points points;
	// VTK's types and all nodes, in VTK's order. Without offsets all cells are quadratic tetrahedra.
	CellList cells;
	/// How far a part may be off, as a share of the cell's size and of the range of an array: between 0 and 1.
	double tolerance = 0.0;

	bool isQuadratic(std::size_t cell) const
	{
		return cells.types[cell] == kQuadraticTetra || cells.types[cell] == kLagrangeTetra;
	}
	/// Returns false for cells that have no inside, or are hidden.
	bool isCut(std::size_t cell) const { return isQuadratic(cell) || isSliceable(cells.types[cell]); }
	/// Returns the place in the connectivity where the nodes of a cell begin.
	std::size_t start(std::size_t cell) const
	{
		return cells.offsets.empty() ? cell * kQuadraticTetraNodes : static_cast<std::size_t>(cells.offsets[cell]);
	}
};

/// Makes a block one of curved cells: it gets the corners of the cells as its grid, and bounds that hold all nodes.
/// Preconditions: the cells with an inside are linear ones, polyhedra apart, or quadratic tetrahedra; ids lie within
/// the points. The block has its fields.
void takeCurvedCells(Block& block, CurvedCells curved);

} // namespace vp::grid
