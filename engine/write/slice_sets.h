#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "write/file_set.h"
#include "write/slice_table.h"

#include <span>
#include <string>

namespace vp::write
{

// A slice as VTK's XML multiblock file (.vtm): a .vtp a sheet, named "sheet 0", "sheet 1" …, in a folder of its stem
// beside it. meshes[i] is sheet i; the .vtp are as writeSlice() writes them.
// Contours are in the file of their sheet.
Status writeVtm(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, const std::string& path,
                std::span<const ContourPiece> contours = {});

// The same from a table for each sheet.
Status writeVtm(std::span<const SliceTable> sheets, const std::string& path);

// Slices over time as ParaView's collection (.pvd): a .vtp a frame with all its sheets, in a folder of its stem beside
// it; the frame's number is its time. All of it appears on commit(), or nothing.
class SliceSeries
{
public:
	static Result<SliceSeries> create(const std::string& path);

	// time: of the input, if the frames are its times; otherwise the number of the frame is the time.
	Status add(int frame, std::optional<double> time, const SliceTable& table);
	Status commit();

private:
	SliceSeries(std::string path, FileSet files) : path_(std::move(path)), files_(std::move(files)) {}

	std::string path_;
	FileSet files_;
	std::string entries_;
};

} // namespace vp::write
