#pragma once

#include "base/huge_vector.h"
#include "grid/build/listed_cells.h"

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

// Throws std::length_error where a grid has no numbers for so many.
CellOrder orderCells(const Points& points, const ListedCells& cells);

} // namespace vp::grid
