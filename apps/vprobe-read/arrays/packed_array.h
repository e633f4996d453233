#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vp::reader::arrays
{

// Thrown if the quick reader does not support a file. VTK then reads it, or says what is wrong with it.
struct NotQuick
{
};

// Memory that a thread uses again and again.
struct Scratch
{
	std::vector<std::byte> unpacked;
	std::vector<std::byte> packed;
	std::vector<char> letters;
};

// Bytes of a file, as they are or written as base64.
class ByteSource
{
public:
	ByteSource() = default;
	ByteSource(int file, std::uint64_t begin, std::uint64_t end, bool is_base64)
	    : file_(file), begin_(begin), end_(end), is_base64_(is_base64)
	{
	}

	// Returns at least the number of bytes, perhaps a few more.
	std::uint64_t size() const { return is_base64_ ? (end_ - begin_) / 4 * 3 : end_ - begin_; }
	// Returns where they begin in the file, or nothing if they are written as base64.
	std::optional<std::uint64_t> begin() const { return is_base64_ ? std::nullopt : std::optional(begin_); }
	// Returns the source without the first bytes of the file. Throws NotQuick past the end.
	ByteSource from(std::uint64_t file_bytes) const;
	// Returns the source behind some bytes that were written as a base64 text of their own.
	ByteSource behind(std::uint64_t bytes) const { return from(is_base64_ ? (bytes + 2) / 3 * 4 : bytes); }
	// Reads bytes. Throws NotQuick if there are too few, or if a letter does not belong to base64.
	void read(std::uint64_t at, std::span<std::byte> to, Scratch& scratch) const;

private:
	void readFile(std::uint64_t at, std::span<std::byte> to) const;

	int file_ = -1;
	std::uint64_t begin_ = 0;
	std::uint64_t end_ = 0;
	bool is_base64_ = false;
};

enum class Codec
{
	none,
	zlib,
	lz4,
	lzma
};

struct Packing
{
	Codec codec = Codec::none;
	std::size_t word_bytes = 4; // the width of the numbers in front of an array
	bool is_big_endian = false; // the numbers in front and those of the array
};

// One array of a VTK XML file: numbers that say how it is packed, then its bytes, in blocks if they are compressed.
class PackedArray
{
public:
	// Reads the numbers in front. Checks every size against the size of the file. Throws NotQuick.
	PackedArray(const ByteSource& source, const Packing& packing, Scratch& scratch);

	std::uint64_t size() const { return size_; } // bytes, unpacked
	// Returns where the bytes lie in the file, one behind the other, or nothing if they are packed.
	std::optional<std::uint64_t> placeInFile() const;
	// Returns the number of letters that the array and the numbers in front take as base64.
	std::uint64_t base64Letters() const;
	// The array is unpacked in parts. Each part has this many bytes, except for the last one.
	std::size_t partBytes() const { return part_bytes_; }
	std::size_t partCount() const { return static_cast<std::size_t>((size_ + part_bytes_ - 1) / part_bytes_); }
	// Returns the first bytes of a part, at most `most`. They are valid until the scratch memory is used again. Throws
	// NotQuick for damaged data.
	std::span<const std::byte> part(std::size_t index, std::uint64_t most, Scratch& scratch) const;

private:
	void readBlockSizes(const ByteSource& source, const Packing& packing, Scratch& scratch);

	ByteSource bytes_;
	Codec codec_ = Codec::none;
	std::size_t word_bytes_ = 4;
	std::uint64_t size_ = 0;
	std::size_t part_bytes_ = 1;
	std::size_t block_bytes_ = 0;
	std::size_t last_block_bytes_ = 0;
	std::vector<std::uint64_t> block_starts_; // compressed; one more than blocks
};

} // namespace vp::reader::arrays
