#include "indexed_file.h"

#include "hdf5_output.h"
#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader::convert
{

namespace
{

bool holds(int file, std::uint64_t offset, std::span<const std::byte> bytes)
{
	std::vector<std::byte> there(std::size_t(1) << 20);
	while (!bytes.empty())
	{
		const ssize_t count =
		    pread(file, there.data(), std::min(there.size(), bytes.size()), static_cast<off_t>(offset));
		if (count <= 0 || std::memcmp(there.data(), bytes.data(), static_cast<std::size_t>(count)) != 0)
			return false;
		offset += static_cast<std::uint64_t>(count);
		bytes = bytes.subspan(static_cast<std::size_t>(count));
	}
	return true;
}

} // namespace

IndexedFile::IndexedFile(const std::string& file, const read::SourceStamp& stamp)
    : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC)), stamp_(stamp)
{
	std::optional<std::vector<quick::PlainArray>> arrays = quick::plainArrays(file);
	if (descriptor_ < 0 || !arrays)
		throw Refusal("is not a .vtu of one piece with arrays appended as raw bytes, and no other file gets an index "
		              "yet; use vprobe pack");
	arrays_ = std::move(*arrays);
}

IndexedFile::~IndexedFile()
{
	if (descriptor_ >= 0)
		close(descriptor_);
}

std::uint64_t IndexedFile::placeOf(bool on_points, const std::string& name, const grid::Field& values) const
{
	const auto found = std::ranges::find_if(arrays_, [&](const quick::PlainArray& array)
	                                        { return array.on_points == on_points && array.name == name; });
	if (found == arrays_.end() || found->type != values.type ||
	    found->components != static_cast<std::uint64_t>(values.components) ||
	    !holds(descriptor_, found->offset, {values.bytes.data(), values.bytes.size()}))
		throw Refusal(fmt::format("has the array {} packed or as text, and an index reads plain numbers alone; use "
		                          "vprobe pack",
		                          name));
	return found->offset;
}

void IndexedFile::writeStamp(hid_t own) const
{
	if (!(read::stampOf(descriptor_) == stamp_))
		throw Refusal("was changed while its index was made; try again when nobody writes it");
	const std::array<std::uint64_t, 5> stamp = {stamp_.device, stamp_.number, stamp_.bytes, stamp_.changed,
	                                            stamp_.head};
	writeValues(own, "Source", H5T_NATIVE_UINT64, {stamp.size()}, stamp.data());
}

void writePlaces(hid_t own, const std::string& name, const grid::Field& values,
                 const std::vector<std::uint64_t>& places)
{
	writeText(own, "Name", name);
	writeText(own, "Type", grid::numberTypeName(values.type));
	writeAttribute(own, "NumberOfComponents", H5T_NATIVE_INT64,
	               std::array{static_cast<std::int64_t>(values.components)});
	writeValues(own, "Places", H5T_NATIVE_UINT64, {places.size()}, places.data());
}

} // namespace vp::reader::convert
