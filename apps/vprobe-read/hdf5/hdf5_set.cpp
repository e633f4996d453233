#include "hdf5_set.h"

#include "hdf5_handle.h"

#include <algorithm>

namespace vp::reader::hdf5
{

std::vector<std::uint64_t> sidesOfSet(hid_t set)
{
	const Handle space(H5Dget_space(set), H5Sclose);
	const int rank = space < 0 ? -1 : H5Sget_simple_extent_ndims(space);
	std::vector<hsize_t> sides(static_cast<std::size_t>(std::max(rank, 0)));
	if (rank > 0)
		H5Sget_simple_extent_dims(space, sides.data(), nullptr);
	return {sides.begin(), sides.end()};
}

std::vector<std::uint64_t> chunkSidesOf(hid_t properties, std::size_t rank)
{
	if (rank < 1 || rank > H5S_MAX_RANK || H5Pget_layout(properties) != H5D_CHUNKED)
		return {};
	std::vector<hsize_t> chunk(rank);
	const int sides = static_cast<int>(rank);
	const bool is_whole = H5Pget_chunk(properties, sides, chunk.data()) == sides &&
	                      std::ranges::none_of(chunk, [](hsize_t side) { return side == 0; });
	return is_whole ? std::vector<std::uint64_t>(chunk.begin(), chunk.end()) : std::vector<std::uint64_t>();
}

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

} // namespace vp::reader::hdf5
