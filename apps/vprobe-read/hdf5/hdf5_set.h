#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <hdf5.h>

namespace vp::reader::hdf5
{

// How the values of a data set lie in its file.

// Returns the sides of a data set, none if it has none.
std::vector<std::uint64_t> sidesOfSet(hid_t set);

// Returns the sides of the chunks, none if the set is not in chunks, or has another rank. properties: of its creation.
std::vector<std::uint64_t> chunkSidesOf(hid_t properties, std::size_t rank);

// Returns the bytes of an item that was never written, as the file would have them.
std::string fillOf(hid_t set, hid_t properties, std::uint64_t components);

} // namespace vp::reader::hdf5
