#include "read/packed_parts.h"

#include "parts/part_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include <fcntl.h>

namespace vp::read
{

namespace
{

constexpr std::array<std::string_view, 4> kReaders = {"hdf5", "netcdf", "tiff", "zarr"};

// The format whose program unpacks. That of VTKHDF knows HDF5, whatever format the file has.
std::string formatOf(const std::string& reader)
{
	const std::string name = reader.substr(0, reader.find(' '));
	return name.empty() || name == "hdf5" ? "vtkhdf" : name;
}

// The input of Zarr is a folder, and the file is one in it.
std::string inputOf(const parts::OpenFile& file, const std::string& reader)
{
	return formatOf(reader) == "zarr" ? std::filesystem::path(file.name()).parent_path().string() : file.name();
}

} // namespace

PackedParts::PackedParts(std::shared_ptr<const parts::OpenFile> file, const parts::Layout& layout, Place place)
    : file_(std::move(file)), place_(std::move(place)),
      unpacker_(inputOf(*file_, place_.reader), formatOf(place_.reader), layout.bytesOf(0),
                place_.reader.empty() ? place_.filters : place_.reader)
{
}

bool PackedParts::knows(const std::string& reader)
{
	return std::ranges::any_of(kReaders, [&](std::string_view name)
	                           { return reader.starts_with(name) && reader.substr(name.size(), 1) == " "; });
}

bool PackedParts::fits(const parts::Layout& layout, const Place& place, std::uint64_t file_size)
{
	if (!place.reader.empty())
		return layout.is_padded;
	const std::uint64_t count = layout.partCount();
	if (!layout.is_padded || place.offsets.size() != count || place.sizes.size() != count ||
	    place.left_out_filters.size() != count)
		return false;
	for (std::uint64_t part = 0; part < count; ++part)
		if (place.offsets[part] != parts::FileExtents::kMissing &&
		    (place.offsets[part] > file_size || place.sizes[part] > file_size - place.offsets[part]))
			return false;
	return true;
}

void PackedParts::announce(std::span<const std::uint64_t> numbers) const
{
	if (!place_.reader.empty())
		return;
	for (const std::uint64_t number : numbers)
		if (place_.offsets[number] != parts::FileExtents::kMissing)
			posix_fadvise(file_->descriptor(), static_cast<off_t>(place_.offsets[number]),
			              static_cast<off_t>(place_.sizes[number]), POSIX_FADV_WILLNEED);
}

void PackedParts::read(std::span<const parts::Wanted> wanted) const
{
	std::vector<Unpacker::Part> there;
	for (const parts::Wanted& part : wanted)
		if (!place_.reader.empty())
			there.push_back({{part.number, 0, 0}, part.bytes});
		else if (place_.offsets[part.number] == parts::FileExtents::kMissing)
			parts::fillItems(part.bytes, place_.fill);
		else
			there.push_back(
			    {{place_.offsets[part.number], place_.sizes[part.number], place_.left_out_filters[part.number]},
			     part.bytes});
	if (!there.empty())
	{
		// The child opens the file by its name.
		if (!file_->isThereStill())
			throw parts::Unreadable(fmt::format("{}: it was replaced while it was open; open it again", file_->name()));
		unpacker_.unpack(there);
	}
	if (place_.swaps)
		for (const parts::Wanted& part : wanted)
			parts::swapNumbers(part.bytes, place_.number_bytes);
}

} // namespace vp::read
