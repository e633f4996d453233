#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace vp::reader::arrays
{

class Writer;

// Says where the values of an array lie in a file, in parts (engine/parts/layout.h).
struct StoredPlace
{
	std::string file{};
	std::array<std::uint64_t, 3> part{1, 1, 1}; // items along i, j, k
	std::uint64_t offset = 0;                   // if the values are in one piece, and a part is some rows of it
	std::vector<std::uint64_t> offsets{};       // else of each part, ~0 for one that was never written
	std::vector<std::uint64_t> sizes{};         // bytes of each part in the file, if they are packed
	std::vector<std::uint64_t> left_out{};      // likewise the filters by which it was not packed (hdf5::Chunk)
	std::string filters{};                      // likewise the filters (hdf5::Filters)
	std::string reader{};                       // how the reader finds parts by their numbers, if nobody else can
	std::string fill{};                         // the bytes of an item that stands for those of such a part
	bool swaps = false;                         // whether the bytes of a number are in the other order
};

// Returns the place of an array in one piece. items: along i, j, k. Its parts are rows, of some 16 KiB.
StoredPlace storedRows(const std::string& file, std::uint64_t offset, const std::array<std::uint64_t, 3>& items,
                       std::uint64_t item_bytes, bool swaps);

// Returns the place of an array whose layers lie anywhere, each in one piece. Its parts are rows, too.
StoredPlace storedLayers(const std::string& file, const std::vector<std::uint64_t>& layers,
                         const std::array<std::uint64_t, 3>& items, std::uint64_t item_bytes, bool swaps);

// Describes such a place for the manifest.
nlohmann::json describeStored(const StoredPlace& place, Writer& writer);

} // namespace vp::reader::arrays
