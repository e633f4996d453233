#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace vp::reader
{

// These functions read numbers from the bytes of a file. parts::swapNumbers turns those of a whole array.

static_assert(std::endian::native == std::endian::little);

enum class ByteOrder
{
	little, // as in memory
	big
};

constexpr ByteOrder byteOrder(bool is_big_endian)
{
	return is_big_endian ? ByteOrder::big : ByteOrder::little;
}

// Returns the number that begins at `place`. All its bytes must be there.
template <class Number>
Number numberAt(const void* place, ByteOrder order = ByteOrder::little)
{
	std::array<char, sizeof(Number)> bytes;
	std::memcpy(bytes.data(), place, bytes.size());
	if (order == ByteOrder::big)
		std::reverse(bytes.begin(), bytes.end());
	return std::bit_cast<Number>(bytes);
}

// Writes a number to `place`, which must have room.
template <class Number>
void putNumber(Number number, void* place, ByteOrder order = ByteOrder::little)
{
	auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
	if (order == ByteOrder::big)
		std::reverse(bytes.begin(), bytes.end());
	std::memcpy(place, bytes.data(), bytes.size());
}

// Returns the unsigned integer of up to 8 bytes that begins at `place`. All its bytes must be there.
inline std::uint64_t integerAt(const void* place, std::size_t width, ByteOrder order = ByteOrder::little)
{
	std::array<char, 8> bytes = {};
	std::memcpy(bytes.data(), place, width);
	if (order == ByteOrder::big)
		std::reverse(bytes.data(), bytes.data() + width);
	return std::bit_cast<std::uint64_t>(bytes);
}

} // namespace vp::reader
