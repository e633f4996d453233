#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace vp::render
{

// Pixels in rows from the top, four bytes each: red, green, blue (sRGB, not multiplied by alpha), alpha.
struct Picture
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	std::vector<std::uint8_t> rgba;

	std::array<std::uint8_t, 4> pixel(std::uint32_t x, std::uint32_t y) const
	{
		const std::uint8_t* p = &rgba[4 * (std::size_t(y) * width + x)];
		return {p[0], p[1], p[2], p[3]};
	}
};

} // namespace vp::render
