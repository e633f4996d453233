#pragma once

#include "base/huge_vector.h"
#include "grid/cell_list.h"
#include "grid/points.h"

#include <cstddef>
#include <cstdint>

namespace vp::grid
{

// Which cells of a list a grid takes, and the order of its cells and points: along one Morton curve.
struct CellOrder
{
	HugeVector<std::uint32_t> cells;  // places in the list
	HugeVector<std::uint32_t> points; // source points; those of no cell come last
	HugeVector<std::uint32_t> rank;   // per source point: its place in `points`
	std::size_t used_points = 0;
	std::size_t left_out = 0; // cells of dimension below three
	bool all_tetrahedra = false;
	bool has_polyhedra = false;
};

/// How many cells of a list a grid takes, and of which kinds.
struct CellCounts
{
	std::size_t kept = 0;     // cells for which isSliceable() holds
	std::size_t left_out = 0; // cells of dimension below three
	std::size_t tetrahedra = 0;
	std::size_t polyhedra = 0;
	bool alike = false; // all cells are kept, and have one type with a table
};

/// Throws std::length_error where a grid has no numbers for so many. One pass over the types, on all cores.
CellCounts countCells(const Points& points, const CellList& cells);

/// Returns how many of the file's cells those in the list are part of. The list has source_cells.
std::size_t countSources(const CellList& cells);

// Throws as countCells() does.
CellOrder orderCells(const Points& points, const CellList& cells);

} // namespace vp::grid
