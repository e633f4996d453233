#pragma once

#include "base/result.h"
#include "base/vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vp::render
{

// A color in sRGB, as in a picture. Blending uses this encoding too, so an opacity of one half gives the mean of two
// colors as a user sees their numbers.
struct Color
{
	std::uint8_t r = 0;
	std::uint8_t g = 0;
	std::uint8_t b = 0;
	std::uint8_t a = 255;

	bool operator==(const Color&) const = default;
};

// Parts from 0 to 1; what is beyond is taken for these.
Color colorOf(const Vec3& rgb, double alpha = 1.0);

constexpr int kColorMapSize = 256;

// A value that stands for something.
struct Category
{
	double value = 0.0;
	std::string name;
	Color color;

	bool operator==(const Category&) const = default;
};

// The colors of values from the range's low end (0) to its high end (1), and of those that have no place in it. NaN is
// magenta in every map of ours. Values outside the range have the colors of its ends; where they are marked, they have
// tints that the map does not hold. Alpha is an opacity by value, a factor on the sheet's.
struct ColorMap
{
	std::string name;
	std::array<Color, kColorMapSize> colors;
	Color nan{217, 70, 160};
	Color below{186, 217, 245};
	Color above{255, 200, 182};
	bool marks_below = false; // values below the range are always marked, as a preset asks for it
	bool marks_above = false;
	std::vector<Category> categories{}; // ascending values; where there are any, `colors` is not used

	Color at(double t) const; // 0..1, linear between neighbors
};

// High and low ends change places; categories keep their names and values, and take each other's colors.
ColorMap reversed(ColorMap map);

const std::vector<std::string>& colorMapNames(); // viridis first, the default

// An unknown name is a usage error that lists the names.
Result<ColorMap> makeColorMap(std::string_view name);

} // namespace vp::render
