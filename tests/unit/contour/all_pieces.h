#pragma once

#include "contour/clip_box.h"
#include "grid/block.h"

#include <cstddef>
#include <set>
#include <utility>

namespace vp::test
{

// Computes a contour by brute force: goes over all cells and clips their polygons one by one. The contour consists of
// the pieces of an iso surface in a box that touch the sheet in its middle.
struct PiecesOnSheet
{
	double area = 0.0;
	std::size_t polygons = 0;
	std::size_t pieces = 0;
	std::set<std::pair<std::size_t, CellId>> cells; // by their blocks
	std::size_t cut_cells = 0;                      // cells that the whole iso surface cuts
};

// field: its first component is what the iso surface is of; every block has it.
PiecesOnSheet piecesOnSheet(const grid::BlockSet& set, const std::string& field, double value,
                            const contour::ClipBox& box);

} // namespace vp::test
