#pragma once

#include "contour/clip_box.h"
#include "grid/block.h"

#include <cstddef>
#include <set>
#include <utility>

namespace vp::test
{

// What a contour is to be, found by going over all cells and clipping their polygons one by one: the pieces of an iso
// surface in a box that touch the sheet in its middle.
struct PiecesOnSheet
{
	double area = 0.0;
	std::size_t polygons = 0;
	std::size_t pieces = 0;
	std::set<std::pair<std::size_t, CellId>> cells; // by their blocks
	std::size_t cut_cells = 0;                      // of the whole iso surface
};

// field: its first component is what the iso surface is of; every block has it.
PiecesOnSheet piecesOnSheet(const grid::BlockSet& set, const std::string& field, double value,
                            const contour::ClipBox& box);

} // namespace vp::test
