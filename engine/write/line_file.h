#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "probe/sheet.h"
#include "write/slice_table.h"

#include <string>

namespace vp::write
{

// From one place of a sheet to another, along its x axis and up, from its origin.
struct SheetLine
{
	glm::dvec2 from{0.0};
	glm::dvec2 to{0.0};
};

// The values along a line through a sheet (content: the one that the mesh is the cut of) as CSV: distance from the
// line's start, u, v, x, y, z, block, cell, and every array as writeSlice() names them. A row stands wherever the line
// crosses an edge of the cut's polygons, and at both its ends; between rows point arrays are linear, and cell arrays
// (block and cell too) hold from a row to the next. Where point arrays jump, as between blocks that differ, there are
// two rows at one distance. Where the line is out of the slice all but the place is nan: in one row in the middle of
// each gap, and at an end that lies outside. "-" is standard output.
//
// table: tabulateAlong(), in whatever order of its polygons.
Status writeLine(const SliceTable& table, const probe::Sheet& content, const SheetLine& line, const std::string& path);

// Returns the polygons that the line may meet.
SliceTable tabulateAlong(const grid::BlockSet& blocks, const probe::Sheet& content, const mesh::SheetMesh& mesh,
                         const SheetLine& line);

} // namespace vp::write
