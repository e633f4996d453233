#include "render/color/color_map_list.h"
#include "render/color/color_spaces.h"

namespace vp::render
{

namespace
{

constexpr Color kNavy{16, 24, 74};
constexpr Color kMaroon{74, 4, 14};

Rgb fractions(Color c)
{
	return Rgb(c.r, c.g, c.b) / 255.0;
}

} // namespace

// K. Moreland, "Diverging Color Maps for Scientific Visualization", 2009.
ColorMap coolWarm()
{
	ColorMap map;
	for (int i = 0; i < kColorMapSize; ++i)
		map.colors[i] = colorOf(between(fractions({59, 76, 192}), fractions({180, 4, 38}),
		                                static_cast<double>(i) / (kColorMapSize - 1), ColorSpace::diverging));
	// The map's own middle is pale.
	map.below = kNavy;
	map.above = kMaroon;
	return map;
}

} // namespace vp::render
