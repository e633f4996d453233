#pragma once

#include "base/vec.h"

namespace vp::render
{

// Red, green and blue from 0 to 1, encoded (sRGB).
using Rgb = Vec3;

// Colors between two, by the names ParaView gives them.
enum class ColorSpace
{
	rgb,
	hsv,       // the shorter way round the hues
	lab,       // CIELAB, D65
	diverging, // K. Moreland, "Diverging Color Maps for Scientific Visualization" (2009)
	step       // the second color throughout
};

// part: from 0 (a) to 1 (b).
Rgb between(const Rgb& a, const Rgb& b, double part, ColorSpace space);

} // namespace vp::render
