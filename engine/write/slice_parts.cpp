#include "write/slice_parts.h"

#include "write/file_set.h"
#include "write/slice_formats.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

namespace vp::write
{

namespace
{

std::string partName(std::size_t number)
{
	return fmt::format("part_{}.vtp", number);
}

} // namespace

Result<SlicePart> SlicePart::write(const SliceTable& table, const std::string& index, std::size_t number)
{
	const Result<std::string> folder = folderOfParts(index);
	if (!folder)
		return folder.error();
	Result<AtomicFile> file = AtomicFile::create(*folder + "/" + partName(number));
	if (!file)
		return file.error();
	writeVtp(table, *file);
	if (Status written = file->close(); !written)
		return written.error();
	return SlicePart(std::move(*file));
}

Status writePartIndex(const SliceTable& like, const std::string& index, std::size_t parts)
{
	const Result<std::string> folder = folderOfParts(index);
	if (!folder)
		return folder.error();
	Result<AtomicFile> file = AtomicFile::create(index);
	if (!file)
		return file.error();
	std::vector<std::string> names;
	for (std::size_t number = 0; number < parts; ++number)
		names.push_back(std::filesystem::path(*folder).filename().string() + "/" + partName(number));
	writePolyDataIndex(polyDataOf(like), names, *file);
	return file->commit();
}

Status writePvtp(const SliceTable& table, const std::string& path)
{
	// Before the part: where there is no room for the index, nothing is left.
	if (Status free = checkWritable(path); !free)
		return free;
	Result<SlicePart> part = SlicePart::write(table, path, 0);
	if (!part)
		return part.error();
	if (Status named = part->commit(); !named)
		return named;
	return writePartIndex(table, path, 1);
}

} // namespace vp::write
