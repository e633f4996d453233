#include "render/color_map.h"

#include "render/color_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::render
{

namespace
{

using Table = std::array<Color, kColorMapSize>;

int hexDigit(char c)
{
	return c <= '9' ? c - '0' : c - 'a' + 10;
}

Table fromHex(const char* text)
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

Table grey()
{
	Table table;
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const auto level = static_cast<std::uint8_t>(i);
		table[i] = {level, level, level};
	}
	return table;
}

// K. Moreland, "Diverging Color Maps for Scientific Visualization" (2009): magnitude, saturation and hue about CIELAB's
// grey axis.
struct Msh
{
	double m;
	double s;
	double h;
};

constexpr double kWhite[3] = {0.95047, 1.0, 1.08883}; // D65

Msh toMsh(Color color)
{
	const auto linear = [](double c)
	{
		c /= 255.0;
		return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
	};
	const double r = linear(color.r);
	const double g = linear(color.g);
	const double b = linear(color.b);
	const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
	const double fx = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / kWhite[0]);
	const double fy = f((0.2126 * r + 0.7152 * g + 0.0722 * b) / kWhite[1]);
	const double fz = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / kWhite[2]);
	const double lightness = 116.0 * fy - 16.0;
	const double a = 500.0 * (fx - fy);
	const double bb = 200.0 * (fy - fz);
	const double m = std::sqrt(lightness * lightness + a * a + bb * bb);
	return {m, m > 1e-3 ? std::acos(lightness / m) : 0.0, std::atan2(bb, a)};
}

Color fromMsh(const Msh& msh)
{
	const double lightness = msh.m * std::cos(msh.s);
	const double a = msh.m * std::sin(msh.s) * std::cos(msh.h);
	const double bb = msh.m * std::sin(msh.s) * std::sin(msh.h);
	const auto inverse = [](double t) { return t > 0.2068966 ? t * t * t : (t - 16.0 / 116.0) / 7.787; };
	const double fy = (lightness + 16.0) / 116.0;
	const double x = kWhite[0] * inverse(fy + a / 500.0);
	const double y = kWhite[1] * inverse(fy);
	const double z = kWhite[2] * inverse(fy - bb / 200.0);
	const auto encoded = [](double c)
	{
		c = std::clamp(c, 0.0, 1.0);
		c = c > 0.0031308 ? 1.055 * std::pow(c, 1.0 / 2.4) - 0.055 : 12.92 * c;
		return static_cast<std::uint8_t>(std::lround(255.0 * c));
	};
	return {encoded(3.2406 * x - 1.5372 * y - 0.4986 * z), encoded(-0.9689 * x + 1.8758 * y + 0.0415 * z),
	        encoded(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

// The hue that a colour starts from so that it fades to a grey of magnitude m with even steps.
double spunHue(const Msh& from, double m)
{
	if (from.m >= m)
		return from.h;
	const double spin = from.s * std::sqrt(m * m - from.m * from.m) / (from.m * std::sin(from.s));
	return from.h > -std::numbers::pi / 3.0 ? from.h + spin : from.h - spin;
}

Table coolWarm()
{
	const Msh ends[2] = {toMsh({59, 76, 192}), toMsh({180, 4, 38})};
	const double middle = std::max({ends[0].m, ends[1].m, 88.0});
	Table table;
	for (int i = 0; i < kColorMapSize; ++i)
	{
		const double t = static_cast<double>(i) / (kColorMapSize - 1);
		const Msh& end = t < 0.5 ? ends[0] : ends[1];
		const double grey = t < 0.5 ? 2.0 * t : 2.0 - 2.0 * t;
		table[i] = fromMsh({(1.0 - grey) * end.m + grey * middle, (1.0 - grey) * end.s,
		                    (1.0 - grey) * end.h + grey * spunHue(end, middle)});
	}
	return table;
}

constexpr Color kPaleBlue{186, 217, 245};
constexpr Color kPaleRed{255, 200, 182};
constexpr Color kNavy{16, 24, 74};
constexpr Color kMaroon{74, 4, 14};

} // namespace

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
	map.below = kPaleBlue;
	map.above = kPaleRed;
	if (name == "viridis")
		map.colors = fromHex(kViridis);
	else if (name == "cividis")
		map.colors = fromHex(kCividis);
	else if (name == "turbo")
		map.colors = fromHex(kTurbo);
	else if (name == "grey")
		map.colors = grey();
	else if (name == "cool-warm")
	{
		map.colors = coolWarm();
		// Its own middle is pale.
		map.below = kNavy;
		map.above = kMaroon;
	}
	else
		return Error{ExitCode::usage, fmt::format("--colormap: there is no '{}'; take one of {}", name,
		                                          fmt::join(colorMapNames(), ", "))};
	return map;
}

} // namespace vp::render
