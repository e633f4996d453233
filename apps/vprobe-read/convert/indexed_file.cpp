#include "indexed_file.h"

#include "hdf5_output.h"
#include "parts/part_bytes.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <span>

namespace vp::reader::convert
{

namespace fs = std::filesystem;

namespace
{

// number_bytes: width of numbers whose bytes are in the other order; 1 if they are not.
bool holds(const parts::OpenFile& file, std::uint64_t offset, std::span<const std::byte> bytes,
           std::size_t number_bytes)
try
{
	if (offset > file.size() || bytes.size() > file.size() - offset)
		return false;
	std::vector<std::byte> there(std::min(bytes.size(), std::size_t(1) << 20));
	while (!bytes.empty())
	{
		const std::span<std::byte> next = std::span(there).first(std::min(there.size(), bytes.size()));
		file.read(offset, next);
		if (number_bytes > 1)
			parts::swapNumbers(next, number_bytes);
		if (std::memcmp(next.data(), bytes.data(), next.size()) != 0)
			return false;
		offset += next.size();
		bytes = bytes.subspan(next.size());
	}
	return true;
}
catch (const parts::Unreadable&)
{
	return false; // it became shorter, which its stamp tells, too
}

// The index would not know when another file is changed.
void refuseOtherFiles(const std::string& file)
{
	if (!fs::is_regular_file(file))
		throw Refusal("is a folder, and an index is of one file; use vprobe pack");
	for (const std::string& read : filesRead())
		if (!fs::equivalent(read, file))
			throw Refusal(fmt::format("names {}, and an index is of one file that names no others; use vprobe pack",
			                          fs::path(read).filename().string()));
}

} // namespace

IndexedFile::IndexedFile(const std::string& file, const read::SourceStamp& stamp)
    : file_((refuseOtherFiles(file), file)), stamp_(stamp), arrays_(plainArraysOf(file))
{
}

std::optional<IndexedFile::Place> IndexedFile::placeOf(bool on_points, const std::string& name,
                                                       const grid::Field& values, std::size_t time) const
{
	for (const arrays::PlainArray& array : arrays_)
	{
		if (array.on_points != on_points || array.name != name || array.type != values.type ||
		    array.components != static_cast<std::uint64_t>(values.components))
			continue;
		const std::size_t count = array.offsets.size(), number_bytes = array.swaps ? grid::byteSize(array.type) : 1;
		for (std::size_t i = 0; i < count; ++i) // the times of a file need not be in order
			if (const std::uint64_t offset = array.offsets[(time + i) % count];
			    holds(file_, offset, {values.bytes.data(), values.bytes.size()}, number_bytes))
				return Place{offset, array.swaps};
	}
	return std::nullopt;
}

void IndexedFile::writeStamp(hid_t own) const
{
	if (!(read::stampOf(file_.descriptor()) == stamp_))
		throw Refusal("was changed while its index was made; try again when nobody writes it");
	const std::array<std::uint64_t, 5> stamp = {stamp_.device, stamp_.number, stamp_.bytes, stamp_.changed,
	                                            stamp_.head};
	writeValues(own, "Source", H5T_NATIVE_UINT64, {stamp.size()}, stamp.data());
}

void writePlaces(hid_t own, const grid::Field& values, const std::vector<std::uint64_t>& places, bool swaps)
{
	writeText(own, "Type", grid::numberTypeName(values.type));
	writeAttribute(own, "NumberOfComponents", H5T_NATIVE_INT64,
	               std::array{static_cast<std::int64_t>(values.components)});
	if (swaps)
		writeAttribute(own, "Swaps", H5T_NATIVE_INT64, std::array{std::int64_t(1)});
	writeValues(own, "Places", H5T_NATIVE_UINT64, {places.size()}, places.data());
}

} // namespace vp::reader::convert
