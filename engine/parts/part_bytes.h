#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace vp::parts
{

/// Turns the bytes of each number of this width.
inline void swapNumbers(std::span<std::byte> bytes, std::size_t width)
{
	for (std::size_t at = 0; at + width <= bytes.size(); at += width)
		std::reverse(bytes.data() + at, bytes.data() + at + width);
}

/// Fills a part with copies of an item.
inline void fillItems(std::span<std::byte> bytes, std::span<const std::byte> item)
{
	for (std::size_t at = 0; at + item.size() <= bytes.size(); at += item.size())
		std::copy(item.begin(), item.end(), bytes.data() + at);
}

} // namespace vp::parts
