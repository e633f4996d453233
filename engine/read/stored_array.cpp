#include "read/stored_array.h"

#include "read/check_mesh.h"
#include "read/formats.h"
#include "read/manifest_values.h"
#include "read/packed_parts.h"
#include "read/protocol.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace vp::read
{

using nlohmann::json;
namespace fs = std::filesystem;

namespace
{

constexpr std::uint64_t kMaxParts = std::uint64_t(1) << 28; // each has a mark in memory

std::array<std::uint32_t, 3> pointsOf(const decltype(CheckedBlock::mesh)& mesh)
{
	return std::visit(
	    [](const auto& grid) -> std::array<std::uint32_t, 3>
	    {
		    using Grid = std::decay_t<decltype(grid)>;
		    if constexpr (std::is_same_v<Grid, grid::UniformGrid> || std::is_same_v<Grid, grid::RectilinearGrid>)
			    return grid.points();
		    else
			    throw Unusable("an array stays in the file where it may not");
	    },
	    mesh);
}

parts::Layout layoutOf(const json& place, const grid::Field& field, const std::array<std::uint32_t, 3>& points)
{
	parts::Layout layout;
	layout.item_bytes = static_cast<std::size_t>(field.components) * byteSize(field.type);
	layout.is_padded = place.contains("offsets") || place.contains("reader");
	const json& part = place.at("part");
	if (!part.is_array() || part.size() != 3)
		throw Unusable("a part of an array has no three sides");
	std::uint64_t bytes = layout.item_bytes;
	std::uint64_t count = 1;
	for (int axis = 0; axis < 3; ++axis)
	{
		layout.items[axis] = points[axis] - (field.association == grid::Association::cell ? 1 : 0);
		layout.part[axis] = countOf(part.at(static_cast<std::size_t>(axis)));
		if (layout.part[axis] < 1 || __builtin_mul_overflow(bytes, layout.part[axis], &bytes) || bytes > kMaxPartBytes)
			throw Unusable("a part of an array is empty or too large");
		count *= layout.partsAlong(axis);
	}
	if (count > kMaxParts) // below 2^32 items there is no overflow
		throw Unusable("an array has too many parts");
	return layout;
}

bool liesIn(const fs::path& file, const fs::path& folder)
{
	std::error_code error;
	const fs::path real = fs::canonical(folder.empty() ? "." : folder, error);
	return !error && std::mismatch(real.begin(), real.end(), file.begin(), file.end()).first == real.end();
}

// The child may read the input, and files in these folders. So a child that somebody else has taken over cannot make
// this process read others.
bool mayBeRead(const std::string& name, const ReadableFiles& files)
{
	const std::string& input = files.input;
	std::error_code absent, unknown;
	const fs::path file = fs::canonical(name, absent);
	const fs::path real_input = fs::canonical(input, unknown);
	if (absent || unknown)
		return false;
	if (file == real_input)
		return true;
	if (fs::is_directory(real_input, absent) && liesIn(file, real_input))
		return true;
	if (mayNameFiles(input) && (liesIn(file, fs::path(input).parent_path()) || liesIn(file, real_input.parent_path())))
		return true;
	std::istringstream folders(files.follow);
	for (std::string folder; std::getline(folders, folder);)
		if (folder == "anywhere" || (!folder.empty() && liesIn(file, folder)))
			return true;
	return false;
}

} // namespace

std::shared_ptr<const parts::OpenFile> openedFile(const std::string& name, const ReadableFiles& files)
{
	if (files.input.empty() || !mayBeRead(name, files))
		throw Unusable("an array stays in a file that the reader may not read");
	return std::make_shared<const parts::OpenFile>(name);
}

std::shared_ptr<const parts::PartStore> storedArray(const json& place, const grid::Field& field,
                                                    const decltype(CheckedBlock::mesh)& mesh, const SharedBytes& arrays,
                                                    const ReadableFiles& files)
{
	const parts::Layout layout = layoutOf(place, field, pointsOf(mesh));
	const auto file = openedFile(place.at("file").get<std::string>(), files);
	const auto listOf = [&](const char* name)
	{ return numbersOf<std::uint64_t>(arrays, place.at(name), grid::NumberType::uint64, layout.partCount()); };
	const auto fill = [&]
	{
		const Array<std::byte> item = bytesOfType(arrays, place.at("fill"), grid::NumberType::uint8, layout.item_bytes);
		return std::vector<std::byte>(item.data(), item.data() + item.size());
	};
	const std::size_t number_bytes = byteSize(field.type);
	const bool swaps = place.at("swaps").get<bool>();
	if (place.contains("reader"))
	{
		PackedParts::Place where{.number_bytes = number_bytes, .swaps = swaps};
		where.reader = place.at("reader").get<std::string>();
		if (!PackedParts::knows(where.reader) || where.reader.find('\0') != std::string::npos)
			throw Unusable("an array stays where nobody can read it");
		return std::make_shared<parts::PartStore>(layout,
		                                          std::make_unique<PackedParts>(file, layout, std::move(where)));
	}
	if (place.contains("filters"))
	{
		PackedParts::Place where{listOf("offsets"),
		                         listOf("sizes"),
		                         listOf("left_out_filters"),
		                         place.at("filters").get<std::string>(),
		                         fill(),
		                         number_bytes,
		                         swaps};
		if (where.filters.find('\0') != std::string::npos || !PackedParts::fits(layout, where, file->size()))
			throw Unusable("an array lies outside of the file");
		return std::make_shared<parts::PartStore>(layout,
		                                          std::make_unique<PackedParts>(file, layout, std::move(where)));
	}
	parts::FileExtents::Place where{.number_bytes = number_bytes, .swaps = swaps};
	if (layout.is_padded)
	{
		where.offsets = listOf("offsets");
		where.fill = fill();
	}
	else
		where.offset = countOf(place.at("offset"));
	if (!parts::FileExtents::fits(layout, where, file->size()))
		throw Unusable("an array lies outside of the file");
	return std::make_shared<parts::PartStore>(layout,
	                                          std::make_unique<parts::FileExtents>(file, layout, std::move(where)));
}

} // namespace vp::read
