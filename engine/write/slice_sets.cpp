#include "write/slice_sets.h"

#include "write/slice_formats.h"
#include "write/xml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace vp::write
{

namespace
{

// Writes a part of `set`. Errors name the set, since a user does not know the place where a part lies until all are
// written.
Status writePart(const SliceTable& table, const FileSet::Member& part, const std::string& set)
{
	Result<AtomicFile> file = AtomicFile::create(part.write_to);
	if (file)
	{
		writeVtp(table, *file);
		if (file->commit())
			return Nothing{};
	}
	return Error{ErrorKind::output,
	             fmt::format("{}: its part {} cannot be written; make room or choose another place", set, part.name)};
}

template <class TableOf>
Status writeSheets(std::size_t sheets, const std::string& path, const TableOf& tableOf)
{
	Result<FileSet> files = FileSet::create(path);
	if (!files)
		return files.error();
	std::string entries;
	for (std::size_t sheet = 0; sheet < sheets; ++sheet)
	{
		const FileSet::Member part = files->add(fmt::format("sheet_{}.vtp", sheet));
		if (Status written = writePart(tableOf(sheet), part, path); !written)
			return written;
		fmt::format_to(std::back_inserter(entries), "\t\t<DataSet index=\"{0}\" name=\"sheet {0}\" file=\"{1}\"/>\n",
		               sheet, xmlText(part.name));
	}
	return files->commit(fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\" "
	                                 "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\t<vtkMultiBlockDataSet>\n{}"
	                                 "\t</vtkMultiBlockDataSet>\n</VTKFile>\n",
	                                 entries));
}

} // namespace

Status writeVtm(const grid::BlockSet& blocks, std::span<const mesh::SheetMesh> meshes, const std::string& path,
                std::span<const ContourPiece> contours)
{
	return writeSheets(meshes.size(), path,
	                   [&](std::size_t sheet)
	                   {
		                   std::vector<ContourPiece> own;
		                   std::ranges::copy_if(contours, std::back_inserter(own),
		                                        [&](const ContourPiece& contour)
		                                        { return std::cmp_equal(contour.sheet, sheet); });
		                   return tabulate(blocks, meshes.subspan(sheet, 1), sheet, own);
	                   });
}

Status writeVtm(std::span<const SliceTable> sheets, const std::string& path)
{
	return writeSheets(sheets.size(), path, [&](std::size_t sheet) -> const SliceTable& { return sheets[sheet]; });
}

Result<SliceSeries> SliceSeries::create(const std::string& path)
{
	Result<FileSet> files = FileSet::create(path);
	if (!files)
		return files.error();
	return SliceSeries(path, std::move(*files));
}

Status SliceSeries::add(int frame, std::optional<double> time, const SliceTable& table)
{
	const FileSet::Member part = files_.add(fmt::format("frame_{:04}.vtp", frame));
	fmt::format_to(std::back_inserter(entries_), "\t\t<DataSet timestep=\"{}\" group=\"\" part=\"0\" file=\"{}\"/>\n",
	               time.value_or(frame), xmlText(part.name));
	return writePart(table, part, path_);
}

Status SliceSeries::commit()
{
	return files_.commit(
	    fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">"
	                "\n\t<Collection>\n{}\t</Collection>\n</VTKFile>\n",
	                entries_));
}

} // namespace vp::write
