#pragma once

#include "base/result.h"
#include "grid/check/quality.h"

#include <span>
#include <string>
#include <vector>

namespace vp::write
{

// Cells with a name for why they are shown.
struct MarkedCells
{
	std::string mark;
	std::vector<grid::SetCell> cells;
};

// Writes the faces of the cells as VTK XML polygons with the cell arrays vprobe:finding (the mark, as text),
// vprobe:cell (source cell id) and vprobe:block. A cell under two marks is there twice. "-" writes to standard output;
// a file appears whole or not at all.
Status writeMarkedCells(const grid::BlockSet& blocks, std::span<const MarkedCells> marked, const std::string& path);

} // namespace vp::write
