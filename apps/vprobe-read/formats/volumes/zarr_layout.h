#pragma once

#include "zarr_codecs.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// The contents of a JSON file as Python writes it, where NaN and Infinity may stand bare. They become texts. Throws a
// Refusal that names the file.
nlohmann::json zarrJson(const std::filesystem::path& file);

// Returns true if the JSON is that of a data set of N5.
bool isOfN5(const nlohmann::json& about);

// How an array of Zarr lies in its folder, as its JSON says.
struct ZarrLayout
{
	std::vector<std::size_t> shape;
	std::vector<std::size_t> chunk;             // the sides of what is packed in one piece
	std::vector<std::size_t> file;              // the sides of what is in one file: of a chunk, or of a shard of them
	std::vector<std::size_t> order;             // the sides from slowest to fastest, as the values lie in a chunk
	ZarrType type;                              // kind 0: no numbers, or numbers that are not read
	std::optional<std::vector<std::byte>> fill; // the value of missing chunks, in the order of bytes of the file
	nlohmann::json codecs = nlohmann::json::array(); // in numcodecs' words, in the order in which they were done
	bool is_sharded = false;
	bool index_is_first = false;     // the index of a shard stands before its chunks, else behind them
	bool index_has_checksum = false; // CRC-32C behind it
	std::string key_front;           // "c" if names of files begin with it
	std::string separators;          // that may stand between indices in names of files: '.', '/' or both
	std::vector<std::size_t> keys;   // the sides in the order of their indices in names of files, and in a shard
	bool has_block_heads = false;    // a head before each chunk says how large it is (N5)

	// `about`: the contents of .zarray, of an array's zarr.json, or of a data set's attributes.json of N5. Throws a
	// Refusal that names the array if they cannot be followed. After "Zarr Storage Specification 2", "Zarr core
	// specification 3.0" and the specification of N5.
	static ZarrLayout of(const nlohmann::json& about, const std::string& name);

	// Puts the sides in another order. order: for each new side which one it was.
	void turn(const std::vector<std::size_t>& order);

	// Returns the names that the file of these chunks or shards may have, within the array's folder.
	std::vector<std::string> namesOfFile(const std::vector<std::size_t>& indices) const;
	// Returns the indices in such a name; nothing for other names.
	std::optional<std::vector<std::size_t>> indicesOf(std::string name) const;
};

} // namespace vp::reader::volumes
