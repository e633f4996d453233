#include "hdf5_stored.h"

#include "hdf5_chunks.h"
#include "hdf5_filters.h"
#include "hdf5_handle.h"
#include "hdf5_parts.h"

#include <algorithm>

namespace vp::reader::hdf5
{

namespace
{

using Sides = std::vector<std::uint64_t>;

Sides sidesOfSpace(hid_t set)
{
	const Handle space(H5Dget_space(set), H5Sclose);
	const int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
	std::vector<hsize_t> sides(static_cast<std::size_t>(std::max(rank, 0)));
	if (rank > 0)
		H5Sget_simple_extent_dims(space, sides.data(), nullptr);
	return {sides.begin(), sides.end()};
}

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

// The bytes of an item that was never written, as the file would have them.
std::string fillOf(hid_t set, hid_t properties, std::uint64_t components)
{
	const Handle type(H5Dget_type(set), H5Tclose);
	std::string number(H5Tget_size(type), '\0');
	H5D_fill_value_t kind = H5D_FILL_VALUE_UNDEFINED;
	if (H5Pfill_value_defined(properties, &kind) >= 0 && kind != H5D_FILL_VALUE_UNDEFINED)
		H5Pget_fill_value(properties, type, number.data());
	std::string item;
	for (std::uint64_t c = 0; c < components; ++c)
		item += number;
	return item;
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
	const Sides sides = sidesOfSpace(set);
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
	const H5D_layout_t kind = H5Pget_layout(properties);
	const haddr_t begin = kind == H5D_CONTIGUOUS ? H5Dget_offset(set) : HADDR_UNDEF;
	if (begin != HADDR_UNDEF)
	{
		std::uint64_t before = 0;
		for (std::size_t i = 0; i < own; ++i)
			before = before * sides[i] + front[i];
		return arrays::storedRows(name_of_file, begin + before * layout.byteCount(), bytes);
	}
	if (kind != H5D_CHUNKED)
		return std::nullopt;
	std::vector<hsize_t> chunk(sides.size());
	if (H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) != static_cast<int>(chunk.size()) ||
	    !std::all_of(chunk.begin(), chunk.begin() + static_cast<long>(own), [](hsize_t n) { return n == 1; }) ||
	    (has_components && chunk.back() != layout.components))
		return std::nullopt;
	const auto chunks = chunksOf(set, name_of_file);
	if (!chunks || chunks->empty())
		return std::nullopt;
	arrays::StoredPlace place{.file = name_of_file,
	                          .part = {chunk[own + 2], chunk[own + 1], chunk[own]},
	                          .fill = fillOf(set, properties, layout.components),
	                          .swaps = *swaps && byteSize(layout.type) > 1};
	std::array<std::uint64_t, 3> along;
	for (std::size_t axis = 0; axis < 3; ++axis)
		along[axis] = (layout.points[axis] + place.part[axis] - 1) / place.part[axis];
	const std::uint64_t count = along[0] * along[1] * along[2];
	place.offsets.assign(count, ~std::uint64_t(0));
	place.filters = filters->text();
	if (!filters->isEmpty())
	{
		place.sizes.assign(count, 0);
		place.left_out.assign(count, 0);
	}
	for (const Chunk& each : *chunks)
	{
		if (!std::equal(front.begin(), front.end(), each.first.begin()))
			continue;
		std::uint64_t number = 0;
		for (std::size_t axis = 3; axis-- > 0;) // k, j, i: the first side is the slowest
		{
			const std::uint64_t at = each.first[own + 2 - axis] / place.part[axis];
			if (at >= along[axis])
				return std::nullopt; // the set was made smaller later
			number = number * along[axis] + at;
		}
		place.offsets[number] = each.offset;
		if (filters->isEmpty())
			continue;
		place.sizes[number] = each.bytes;
		place.left_out[number] = each.left_out_filters;
	}
	return place;
}

} // namespace vp::reader::hdf5
