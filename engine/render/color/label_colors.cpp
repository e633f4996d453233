#include "render/color/label_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::render
{

namespace
{

constexpr std::array<Color, 19> kKelly{
    Color{0xf3, 0xc3, 0x00}, {0x87, 0x56, 0x92}, {0xf3, 0x84, 0x00}, {0xa1, 0xca, 0xf1}, {0xbe, 0x00, 0x32},
    {0xc2, 0xb2, 0x80},      {0x00, 0x88, 0x56}, {0xe6, 0x8f, 0xac}, {0x00, 0x67, 0xa5}, {0xf9, 0x93, 0x79},
    {0x60, 0x4e, 0x97},      {0xf6, 0xa6, 0x00}, {0xb3, 0x44, 0x6c}, {0xdc, 0xd3, 0x00}, {0x88, 0x2d, 0x17},
    {0x8d, 0xb6, 0x00},      {0x65, 0x45, 0x22}, {0xe2, 0x58, 0x22}, {0x2b, 0x3d, 0x26}};
constexpr Color kNothing{0xd9, 0xd9, 0xd9}; // 0
constexpr std::size_t kShades = 3;          // as they are, lighter, darker
constexpr double kOwnColors = kKelly.size();

Color mixed(const Color& a, std::uint8_t level, double part)
{
	const auto mix = [&](std::uint8_t channel)
	{ return static_cast<std::uint8_t>(std::lround(channel + part * (level - channel))); };
	return {mix(a.r), mix(a.g), mix(a.b), a.a};
}

// number: from 0.
Color labelColor(std::size_t number)
{
	const Color& color = kKelly[number % kKelly.size()];
	const std::size_t shade = number / kKelly.size() % kShades;
	return shade == 1 ? mixed(color, 255, 0.5) : shade == 2 ? mixed(color, 0, 0.45) : color;
}

} // namespace

ColorMap labelColors(std::span<const double> values)
{
	const bool have_own = std::ranges::all_of(
	    values, [](double value) { return value >= 0.0 && value <= kOwnColors && value == std::floor(value); });
	ColorMap map;
	map.name = kLabelsName;
	std::size_t number = 0;
	for (const double value : values)
	{
		const Color color = value == 0.0 ? kNothing
		                    : have_own   ? labelColor(static_cast<std::size_t>(value) - 1)
		                                 : labelColor(number++);
		map.categories.push_back({value, fmt::format("{}", value), color});
	}
	for (std::size_t i = 0; i < map.colors.size() && !map.categories.empty(); ++i)
		map.colors[i] = map.categories[i % map.categories.size()].color;
	return map;
}

} // namespace vp::render
