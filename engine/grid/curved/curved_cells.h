#pragma once

#include "grid/block.h"
#include "grid/curved/curved_types.h"
#include "grid/points.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace vp::grid
{

inline constexpr int kQuadraticTetraNodes = 10;

/// Cells with nodes between their corners, as a file lists them, beside linear cells. A cut refines those that it
/// meets.
struct CurvedCells
{
	Points points;
	// VTK's types and all nodes, in VTK's order since 9.1. Without offsets all cells are quadratic tetrahedra.
	CellList cells;
	/// How far a part may be off, as a share of the cell's size and of the range of an array: between 0 and 1.
	double tolerance = 0.0;
	Array<std::int32_t> degrees{}; // three for each cell; empty: the number of nodes tells
	Array<double> weights{};       // weights of the points, above 0, which make Bezier cells rational; or empty

	/// Returns true for quadratic tetrahedra.
	bool isQuadratic(std::size_t cell) const
	{
		const std::uint8_t type = cells.types[cell];
		return type == kQuadraticTetra || (type == kLagrangeTetra && nodes(cell) == kQuadraticTetraNodes);
	}
	bool isCurved(std::size_t cell) const { return grid::isCurved(cells.types[cell]); }
	/// Returns false for cells that have no inside, or are hidden.
	bool isCut(std::size_t cell) const { return isCurved(cell) || isSliceable(cells.types[cell]); }
	/// Returns the place in the connectivity where the nodes of a cell begin.
	std::size_t start(std::size_t cell) const
	{
		return cells.offsets.empty() ? cell * kQuadraticTetraNodes : static_cast<std::size_t>(cells.offsets[cell]);
	}
	std::size_t nodes(std::size_t cell) const
	{
		return cells.offsets.empty() ? kQuadraticTetraNodes
		                             : static_cast<std::size_t>(cells.offsets[cell + 1] - cells.offsets[cell]);
	}
	std::size_t node(std::size_t cell, std::size_t n) const
	{
		return static_cast<std::size_t>(cells.connectivity[start(cell) + n]);
	}
	/// Returns the degrees along the axes of a cell of a type for which hasDegrees() is true.
	std::array<int, 3> degreesOf(std::size_t cell) const;
};

/// Makes a block one of curved cells: it gets the corners of the cells as its grid, and bounds that hold all nodes.
/// Preconditions: the cells with an inside are linear ones, polyhedra apart, or curved ones with the number of nodes
/// that their type and degrees say; ids lie within the points. The block has its fields.
void takeCurvedCells(Block& block, CurvedCells curved);

} // namespace vp::grid
