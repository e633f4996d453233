#include "render/color/color_map.h"

#include "render/color/color_spaces.h"
#include "render/color/color_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vp::render
{

namespace
{

using Table = std::array<Color, kColorMapSize>;

int hexDigit(char c)
{
	return c <= '9' ? c - '0' : c - 'a' + 10;
}

Table tableFromHex(const char* text)
{
	Table table;
	for (Color& color : table)
	{
		const auto next = [&text]
		{
			const int value = 16 * hexDigit(text[0]) + hexDigit(text[1]);
			text += 2;
			return static_cast<std::uint8_t>(value);
		};
		color.r = next();
		color.g = next();
		color.b = next();
	}
	return table;
}

Table gray()
{
	Table table;
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const auto level = static_cast<std::uint8_t>(i);
		table[i] = {level, level, level};
	}
	return table;
}

Rgb fractions(Color c)
{
	return Rgb(c.r, c.g, c.b) / 255.0;
}

Table coolWarm()
{
	Table table;
	for (int i = 0; i < kColorMapSize; ++i)
		table[i] = colorOf(between(fractions({59, 76, 192}), fractions({180, 4, 38}),
		                           static_cast<double>(i) / (kColorMapSize - 1), ColorSpace::diverging));
	return table;
}

constexpr Color kNavy{16, 24, 74};
constexpr Color kMaroon{74, 4, 14};

} // namespace

Color colorOf(const Vec3& rgb, double alpha)
{
	const auto byte = [](double part)
	{ return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(part, 0.0, 1.0))); };
	return {byte(rgb.r), byte(rgb.g), byte(rgb.b), byte(alpha)};
}

ColorMap reversed(ColorMap map)
{
	std::reverse(map.colors.begin(), map.colors.end());
	for (std::size_t i = 0, j = map.categories.size(); i + 1 < j; ++i)
		std::swap(map.categories[i].color, map.categories[--j].color);
	return map;
}

Color ColorMap::at(double t) const
{
	const double place = std::clamp(t, 0.0, 1.0) * (kColorMapSize - 1);
	const int low = std::min(static_cast<int>(place), kColorMapSize - 2);
	const double part = place - low;
	const auto mix = [part](std::uint8_t a, std::uint8_t b)
	{ return static_cast<std::uint8_t>(std::lround(a + part * (b - a))); };
	const Color& a = colors[low];
	const Color& b = colors[low + 1];
	return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

const std::vector<std::string>& colorMapNames()
{
	static const std::vector<std::string> names{"viridis", "cividis", "turbo", "cool-warm", "grey"};
	return names;
}

Result<ColorMap> makeColorMap(std::string_view name)
{
	ColorMap map;
	map.name = name;
	if (name == "viridis")
		map.colors = tableFromHex(kViridis);
	else if (name == "cividis")
		map.colors = tableFromHex(kCividis);
	else if (name == "turbo")
		map.colors = tableFromHex(kTurbo);
	else if (name == "grey")
		map.colors = gray();
	else if (name == "cool-warm")
	{
		map.colors = coolWarm();
		// Its own middle is pale.
		map.below = kNavy;
		map.above = kMaroon;
	}
	else
		return Error{ErrorKind::usage,
		             fmt::format("`colormap`: there is no '{}'; take one of {}, or a FILE.json of ParaView's", name,
		                         fmt::join(colorMapNames(), ", "))};
	return map;
}

} // namespace vp::render
