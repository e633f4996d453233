#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "write/slice_table.h"

#include <span>
#include <string>

namespace vp::write
{

enum class SliceFormat
{
	vtp, // VTK XML polygons, all arrays
	ply, // binary, all arrays as properties
	csv, // a row per polygon corner, all arrays as columns
	vtm, // VTK XML multiblock: a .vtp a sheet, in a folder of the file's stem beside it
	pvtp // VTK XML parallel polygons: a .vtp a process, in such a folder
};

// By the path's ending (.vtp .ply .csv .vtm .pvtp, any case); "-" is VTP. A usage error names the endings there are.
Result<SliceFormat> sliceFormatOf(const std::string& path);

// Writes the sheets' polygons (meshes[i] is sheet i) with every point array interpolated to the vertices, every cell
// array, and the cell arrays vprobe:cell (source cell id), vprobe:block and vprobe:sheet. An array that a block lacks
// is NaN (0 for integers) there.
// contours: stand behind the sheets' polygons, with the cell array vprobe:contour (NaN on those).
// "-" writes to standard output. A file appears whole or not at all (written beside its place and renamed), a .vtm or
// .pvtp with all that belongs to it; a failure is an output error.
Status writeSlice(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, const std::string& path,
                  std::span<const ContourPiece> contours = {});

// Writes a table as .vtp, .ply, .csv or .pvtp (of one part), by the path's ending, as writeSlice() does.
Status writeTable(const SliceTable& table, const std::string& path);

} // namespace vp::write
