#include "hdf5_stored.h"

#include "hdf5_chunks.h"
#include "hdf5_filters.h"
#include "hdf5_handle.h"
#include "hdf5_parts.h"
#include "hdf5_set.h"
#include "read/protocol.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vp::reader::hdf5
{

namespace
{

// Whether the bytes of numbers are in the other order; nothing if they are not simply the numbers of a type in memory.
std::optional<bool> swapsBytes(hid_t set, grid::NumberType type)
{
	const Handle given(H5Dget_type(set), H5Tclose);
	const Handle swapped(H5Tcopy(nativeType(type)), H5Tclose);
	if (given < 0 || swapped < 0 || H5Tset_order(swapped, H5T_ORDER_BE) < 0)
		return std::nullopt;
	if (H5Tequal(given, nativeType(type)) > 0)
		return false;
	return H5Tequal(given, swapped) > 0 ? std::optional(true) : std::nullopt;
}

// The file that holds the set, which is another one where a link leads there.
std::string fileOfSet(hid_t set, const std::string& name_of_file)
{
	const Handle opened(H5Iget_file_id(set), H5Fclose);
	std::array<char, 4096> name = {};
	const ssize_t length = opened < 0 ? -1 : H5Fget_name(opened, name.data(), name.size());
	return length > 0 && length < static_cast<ssize_t>(name.size()) ? name.data() : name_of_file;
}

// Notes for each part the chunk that holds it. Returns nothing if chunks are of no part.
std::optional<arrays::StoredPlace> placeChunks(arrays::StoredPlace place, const std::vector<Chunk>& chunks,
                                               const Filters& filters, const arrays::ValueLayout& layout,
                                               const std::vector<std::uint64_t>& front)
{
	if (chunks.empty())
		return std::nullopt;
	std::array<std::uint64_t, 3> along;
	for (std::size_t axis = 0; axis < 3; ++axis)
		along[axis] = (layout.points[axis] + place.part[axis] - 1) / place.part[axis];
	const std::uint64_t count = along[0] * along[1] * along[2];
	place.offsets.assign(count, ~std::uint64_t(0));
	place.filters = filters.text();
	if (!filters.isEmpty())
	{
		place.sizes.assign(count, 0);
		place.left_out.assign(count, 0);
	}
	for (const Chunk& each : chunks)
	{
		if (!std::equal(front.begin(), front.end(), each.first.begin()))
			continue;
		std::uint64_t number = 0;
		for (std::size_t axis = 3; axis-- > 0;) // k, j, i: the first side is the slowest
		{
			const std::uint64_t at = each.first[front.size() + 2 - axis] / place.part[axis];
			if (at >= along[axis])
				return std::nullopt; // the set was made smaller later
			number = number * along[axis] + at;
		}
		place.offsets[number] = each.offset;
		if (filters.isEmpty())
			continue;
		place.sizes[number] = each.bytes;
		place.left_out[number] = each.left_out_filters;
	}
	return place;
}

} // namespace

std::optional<arrays::StoredPlace> storedPlaceOf(hid_t file, const std::string& name_of_file, const std::string& path,
                                                 const arrays::ValueLayout& layout,
                                                 const std::vector<std::uint64_t>& front)
{
	const Handle set = openedSet(file, path);
	const Handle properties(set < 0 ? -1 : H5Dget_create_plist(set), H5Pclose);
	const std::optional<Filters> filters = properties < 0 ? std::nullopt : Filters::of(properties);
	if (!filters || H5Pget_external_count(properties) > 0)
		return std::nullopt;
	const std::optional<bool> swaps = swapsBytes(set, layout.type);
	const std::vector<std::uint64_t> sides = sidesOfSet(set);
	const std::size_t own = front.size();
	const bool has_components = sides.size() == own + 4;
	if (!swaps || (sides.size() != own + 3 && !has_components) || (layout.components != 1 && !has_components))
		return std::nullopt;
	for (std::size_t i = 0; i < own; ++i)
		if (front[i] >= sides[i])
			return std::nullopt;
	for (std::size_t axis = 0; axis < 3; ++axis)
		if (sides[own + 2 - axis] != layout.points[axis])
			return std::nullopt;
	if (has_components && sides.back() != layout.components)
		return std::nullopt;
	arrays::ValueLayout bytes = layout;
	bytes.is_big_endian = *swaps;
	if (H5Pget_layout(properties) == H5D_CONTIGUOUS)
	{
		const haddr_t begin = H5Dget_offset(set);
		std::uint64_t before = 0;
		for (std::size_t i = 0; i < own; ++i)
			before = before * sides[i] + front[i];
		return begin == HADDR_UNDEF ? std::nullopt
		                            : std::optional(arrays::storedRows(fileOfSet(set, name_of_file),
		                                                               begin + before * layout.byteCount(), bytes));
	}
	const std::vector<std::uint64_t> chunk = chunkSidesOf(properties, sides.size());
	std::uint64_t chunk_bytes = byteSize(layout.type);
	for (const std::uint64_t side : chunk)
		if (__builtin_mul_overflow(chunk_bytes, side, &chunk_bytes))
			return std::nullopt;
	if (chunk.empty() || chunk_bytes > read::kMaxPartBytes ||
	    !std::all_of(chunk.begin(), chunk.begin() + static_cast<long>(own), [](auto n) { return n == 1; }) ||
	    (has_components && chunk.back() != layout.components))
		return std::nullopt;
	arrays::StoredPlace place{.file = fileOfSet(set, name_of_file),
	                          .part = {chunk[own + 2], chunk[own + 1], chunk[own]},
	                          .swaps = *swaps && byteSize(layout.type) > 1};
	if (const auto chunks = chunksOf(set, place.file))
	{
		place.fill = fillOf(set, properties, layout.components);
		return placeChunks(std::move(place), *chunks, *filters, layout, front);
	}
	H5D_space_status_t written = H5D_SPACE_STATUS_ERROR;
	if (H5Dget_space_status(set, &written) < 0 || written == H5D_SPACE_STATUS_NOT_ALLOCATED)
		return std::nullopt;
	place.file = name_of_file; // links are followed from there
	place.reader = fmt::format("hdf5 {} {}{}{}", own, fmt::join(front, " "), own > 0 ? " " : "", path);
	return place;
}

std::optional<std::uint64_t> plainOffsetOf(hid_t file, const std::string& name_of_file, const std::string& path,
                                           grid::NumberType type)
{
	const Handle set = openedSet(file, path);
	const Handle properties(set < 0 ? -1 : H5Dget_create_plist(set), H5Pclose);
	if (properties < 0 || H5Pget_external_count(properties) > 0 || H5Pget_layout(properties) != H5D_CONTIGUOUS ||
	    swapsBytes(set, type) != std::optional(false) || fileOfSet(set, name_of_file) != name_of_file)
		return std::nullopt;
	const haddr_t begin = H5Dget_offset(set);
	return begin == HADDR_UNDEF ? std::nullopt : std::optional<std::uint64_t>(begin);
}

} // namespace vp::reader::hdf5
