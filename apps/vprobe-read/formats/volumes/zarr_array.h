#pragma once

#include "vprobe-read/arrays/stored_place.h"
#include "zarr_codecs.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace vp::reader::volumes
{

// The contents of a JSON file as Python writes it, where NaN and Infinity may stand bare. They become texts. Throws a
// Refusal that names the file.
nlohmann::json zarrJson(const std::filesystem::path& file);

// An array of Zarr 2: a folder with a file for each chunk. After "Zarr Storage Specification 2".
class ZarrArray
{
public:
	// `about`: the contents of its .zarray. Throws a Refusal where they cannot be followed, or name a codec that is
	// not read.
	ZarrArray(std::filesystem::path folder, std::string name, const nlohmann::json& about);

	const std::string& name() const { return name_; }
	const std::vector<std::size_t>& shape() const { return shape_; }
	// Floats of 2 bytes are given as those of 4.
	const ZarrType& type() const { return type_; }
	std::size_t widthInMemory() const { return isHalf() ? 4 : type_.width; }

	// A part of it, the last side fastest, in the order of bytes of this machine. Chunks that are not there have the
	// fill value; without one, NaN. Throws a Refusal for whole numbers without one. `to` has room.
	void read(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts, std::byte* to) const;

	// Returns the place of a lattice that is the last three sides, at these indices of the others. Its parts are the
	// chunks. Returns nothing for fewer sides.
	std::optional<arrays::StoredPlace> storedPlace(const std::vector<std::size_t>& front) const;
	// Reads such a part. Its last three sides are those of a chunk, also where that reaches beyond the array.
	void readPart(const std::vector<std::size_t>& front, std::uint64_t number, std::span<std::byte> to) const;
	std::size_t partBytes() const;

private:
	struct Chunk
	{
		std::filesystem::path file;
		std::vector<std::size_t> begin; // of its values in the array
	};

	bool isHalf() const { return type_.kind == 'f' && type_.width == 2; }
	void takeFill(const nlohmann::json& given);
	std::optional<std::vector<Chunk>> fewChunksIn(const std::vector<std::size_t>& starts,
	                                              const std::vector<std::size_t>& counts) const;
	std::vector<Chunk> chunksIn(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts) const;
	std::vector<std::byte> unpacked(const Chunk& chunk) const;
	std::size_t copy(const Chunk& chunk, const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts,
	                 std::byte* to) const;

	std::filesystem::path folder_;
	std::string name_;
	std::vector<std::size_t> shape_, chunk_;
	ZarrType type_;
	std::size_t chunk_bytes_ = 0;
	bool is_fortran_ = false;
	std::optional<std::vector<std::byte>> fill_; // in the order of bytes of the file
	ZarrCodecs codecs_;
};

} // namespace vp::reader::volumes
