#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace vp::reader::volumes
{

// A type of numbers as NumPy writes it: "<f4".
struct ZarrType
{
	char kind = 0; // i, u, f, b for booleans; 0 where it is no number that is read
	std::size_t width = 0;
	bool is_big_endian = false;

	// Reads a type of 1, 2, 4 or 8 bytes, or a float of 2 bytes.
	static ZarrType of(const nlohmann::json& given);
};

// How the bytes of chunks were packed: filters one after the other, then a compressor.
class ZarrCodecs
{
public:
	// `codecs`: a list in numcodecs' words, in the order in which they were done. Throws a Refusal that names a codec
	// which is not known, and the array.
	ZarrCodecs(const nlohmann::json& codecs, const std::string& array);

	bool isEmpty() const { return steps_.empty(); }
	// Throws a Refusal unless the packed bytes give exactly `bytes` ones.
	// `where`: which chunk, for that line.
	std::vector<std::byte> unpack(std::span<const std::byte> packed, std::size_t bytes, const std::string& where) const;

private:
	struct Step
	{
		std::string id;
		ZarrType plain, stored; // for filters that compute with numbers
		std::size_t width = 0;  // bytes of the items that are shuffled
		double scale = 1.0, offset = 0.0;

		bool addsChecksum() const { return id.starts_with("crc32"); }
		std::size_t packedSize(std::size_t bytes) const;
		bool undo(std::span<const std::byte> packed, std::span<std::byte> to) const;
		bool undoNumbers(std::span<const std::byte> packed, std::span<std::byte> to) const;
	};

	static Step stepOf(const nlohmann::json& codec, const std::string& array);

	std::vector<Step> steps_; // in the order in which they were done
};

} // namespace vp::reader::volumes
