#pragma once

#include "render/scene/value_style.h"

namespace vp::render
{

// Colors of values, each from one bound to the next: bounds[i] is the least value of colors[i + 1].
struct ColorSteps
{
	std::vector<double> bounds; // ascending
	std::vector<Color> colors;  // one more

	std::size_t at(double value) const; // which color
	bool opaque() const;
};

// Returns the color steps of a style: its bands or categories, else `steps` equal parts of the color map. The colors
// for values beyond its range are added.
ColorSteps colorSteps(const ValueStyle& style, int steps);

} // namespace vp::render
