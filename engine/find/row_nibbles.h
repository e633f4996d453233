#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace vp::find
{

// The four bits of the index as four bytes of 0 or 1, the lowest bit first in memory.
constexpr std::array<std::uint32_t, 16> kNibbleBytes = []
{
	std::array<std::uint32_t, 16> bytes{};
	for (unsigned bits = 0; bits < bytes.size(); ++bits)
		for (unsigned v = 0; v < 4; ++v)
			bytes[bits] |= (bits >> v & 1u) << (std::endian::native == std::endian::little ? 8 * v : 24 - 8 * v);
	return bytes;
}();

} // namespace vp::find
