#include "write/slice_file.h"

#include "write/slice_formats.h"
#include "write/slice_parts.h"
#include "write/slice_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace vp::write
{

Result<SliceFormat> sliceFormatOf(const std::string& path)
{
	std::string ending = std::filesystem::path(path).extension().string();
	std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
	if (ending == ".vtp")
		return SliceFormat::vtp;
	if (ending == ".ply")
		return SliceFormat::ply;
	if (ending == ".csv")
		return SliceFormat::csv;
	if (ending == ".vtm")
		return SliceFormat::vtm;
	if (ending == ".pvtp")
		return SliceFormat::pvtp;
	// A pipe or a device has no ending to choose; it is standard output by another name.
	std::error_code failed;
	if (path == "-" || (ending.empty() && std::filesystem::is_other(path, failed)))
		return SliceFormat::vtp;
	return Error{
	    ErrorKind::usage,
	    fmt::format("{}: not a file a slice can be written to; use the ending .vtp, .vtm, .pvtp, .ply or .csv, "
	                "or, for a picture, .png, .svg or .pdf",
	                path)};
}

Status writeSlice(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, const std::string& path,
                  std::span<const ContourPiece> contours)
{
	const Result<SliceFormat> format = sliceFormatOf(path);
	if (!format)
		return format.error();
	return *format == SliceFormat::vtm ? writeVtm(blocks, meshes, path, contours)
	                                   : writeTable(tabulate(blocks, meshes, 0, contours), path);
}

Status writeTable(const SliceTable& table, const std::string& path)
{
	const Result<SliceFormat> format = sliceFormatOf(path);
	if (!format)
		return format.error();
	if (*format == SliceFormat::pvtp)
		return writePvtp(table, path);
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	switch (*format)
	{
	case SliceFormat::vtp:
		writeVtp(table, *file);
		break;
	case SliceFormat::ply:
		writePly(table, *file);
		break;
	case SliceFormat::csv:
		writeCsv(table, *file);
		break;
	case SliceFormat::vtm:
	case SliceFormat::pvtp:
		return Error{ErrorKind::usage, fmt::format("{}: a table is one file; give a .vtp", path)};
	}
	return file->commit();
}

} // namespace vp::write
