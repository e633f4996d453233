#include "render/color/color_map.h"

#include "render/color/color_map_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::render
{

namespace
{

struct NamedMap
{
	const char* name;
	ColorMap (*make)();
};

#define VP_ENTRY(name, make) NamedMap{name, make},
const std::array kMaps{VP_COLOR_MAPS(VP_ENTRY)};
#undef VP_ENTRY

int hexDigit(char c)
{
	return c <= '9' ? c - '0' : c - 'a' + 10;
}

} // namespace

ColorMap mapFromHex(const char* digits)
{
	ColorMap map;
	for (Color& color : map.colors)
		for (std::uint8_t* part : {&color.r, &color.g, &color.b})
		{
			*part = static_cast<std::uint8_t>(16 * hexDigit(digits[0]) + hexDigit(digits[1]));
			digits += 2;
		}
	return map;
}

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
	static const std::vector<std::string> names = []
	{
		std::vector<std::string> all;
		for (const NamedMap& map : kMaps)
			all.emplace_back(map.name);
		return all;
	}();
	return names;
}

Result<ColorMap> makeColorMap(std::string_view name)
{
	const auto found = std::ranges::find(kMaps, name == "gray" ? "grey" : name, &NamedMap::name);
	if (found == kMaps.end())
		return Error{ErrorKind::usage,
		             fmt::format("`colormap`: there is no '{}'; take one of {}, or a FILE.json of ParaView's", name,
		                         fmt::join(colorMapNames(), ", "))};
	ColorMap map = found->make();
	map.name = found->name;
	return map;
}

} // namespace vp::render
