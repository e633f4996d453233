#pragma once

#include "vprobe-read/arrays/stored_place.h"
#include "zarr_codecs.h"
#include "zarr_layout.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::reader::volumes
{

// An array of Zarr: a folder with a file for each chunk, or for each shard of chunks.
class ZarrArray
{
public:
	// `about`: the JSON of the array. Throws a Refusal if it cannot be followed, or names a codec that is not read.
	ZarrArray(std::filesystem::path folder, std::string name, const nlohmann::json& about);
	~ZarrArray();
	ZarrArray(ZarrArray&&) noexcept;

	// Puts the sides in another order. order: for each new side which one of the given ones it is.
	void turn(const std::vector<std::size_t>& order);

	const std::string& name() const { return name_; }
	const std::vector<std::size_t>& shape() const { return layout_.shape; }
	const std::vector<std::size_t>& chunk() const { return layout_.chunk; }
	// Floats of 2 bytes are given as those of 4.
	const ZarrType& type() const { return layout_.type; }
	std::size_t widthInMemory() const { return isHalf() ? 4 : layout_.type.width; }

	// Reads a part of it, the last side fastest, in the order of bytes of this machine. Chunks that are not there have
	// the fill value; without one, NaN. Throws a Refusal for whole numbers without one. `to` has room.
	void read(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts, std::byte* to) const;

	// Returns the place of a lattice that is the last three sides, at these indices of the others. Its parts are the
	// chunks. Returns nothing for fewer sides.
	std::optional<arrays::StoredPlace> storedPlace(const std::vector<std::size_t>& front) const;
	// Reads such a part. Its last three sides are those of a chunk, also where that reaches beyond the array.
	void readPart(const std::vector<std::size_t>& front, std::uint64_t number, std::span<std::byte> to) const;
	std::size_t partBytes() const;

private:
	class Shard;
	class CheckedShards;
	struct File
	{
		std::filesystem::path path;
		std::vector<std::size_t> indices;
	};

	bool isHalf() const { return layout_.type.kind == 'f' && layout_.type.width == 2; }
	std::optional<std::vector<File>> fewFilesIn(const std::vector<std::size_t>& starts,
	                                            const std::vector<std::size_t>& counts) const;
	std::vector<File> filesIn(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& counts) const;
	std::size_t copyFile(const File& file, const std::vector<std::size_t>& starts,
	                     const std::vector<std::size_t>& counts, std::byte* to) const;
	std::vector<std::size_t> takeBlockHead(std::span<const std::byte>& packed, const std::string& where) const;
	std::size_t copyChunk(std::span<const std::byte> packed, const std::vector<std::size_t>& begin,
	                      const std::string& where, const std::vector<std::size_t>& starts,
	                      const std::vector<std::size_t>& counts, std::byte* to) const;

	std::filesystem::path folder_;
	std::string name_;
	ZarrLayout layout_;
	ZarrCodecs codecs_;
	std::unique_ptr<CheckedShards> checked_;
	std::vector<std::size_t> turned_; // as it was turned; empty if it was not
};

// Returns the JSON of the array in a folder, or nothing if there is none.
std::optional<nlohmann::json> zarrArrayJson(const std::filesystem::path& folder);

} // namespace vp::reader::volumes
