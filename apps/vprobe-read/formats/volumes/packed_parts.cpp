#include "vprobe-read/arrays/packed_parts.h"

#include "vprobe-read/base/mapped_text.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/hdf5/hdf5_filters.h"
#include "zarr_array.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <sstream>
#include <vector>

namespace vp::reader
{

namespace
{

arrays::UnpackPart fromChunks(const std::string& name, const std::string& filters)
{
	const auto file = std::make_shared<const MappedText>(name);
	return [file, steps = hdf5::Filters(filters)](const arrays::PackedPart& part, std::span<std::byte> to)
	{
		if (part.offset > file->text().size() || part.bytes > file->text().size() - part.offset)
			throw damaged("a part lies outside of it");
		const auto packed = std::as_bytes(std::span(file->text().substr(part.offset, part.bytes)));
		steps.unpack(packed, static_cast<std::uint32_t>(part.left_out_filters), to);
	};
}

arrays::UnpackPart fromZarr(const std::filesystem::path& folder, std::istream& indices)
{
	const auto about = volumes::zarrArrayJson(folder);
	if (!about)
		throw Refusal("its array is not there any more");
	const auto array = std::make_shared<const volumes::ZarrArray>(folder, folder.filename().string(), *about);
	std::vector<std::size_t> front;
	for (std::size_t index = 0; indices >> index;)
		front.push_back(index);
	return [array, front](const arrays::PackedPart& part, std::span<std::byte> to)
	{ array->readPart(front, part.offset, to); };
}

} // namespace

arrays::UnpackPart arrays::unpackerOf(const std::string& file, const std::string& how)
{
	std::istringstream words(how);
	std::string reader;
	words >> reader;
	return reader == "zarr" ? fromZarr(file, words) : fromChunks(file, how);
}

} // namespace vp::reader
