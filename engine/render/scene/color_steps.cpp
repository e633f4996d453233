#include "render/scene/color_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render
{

namespace
{

double valueAt(const ValueStyle& style, double part)
{
	return style.logarithmic ? style.lo * std::pow(style.hi / style.lo, part) : style.lo + part * (style.hi - style.lo);
}

ColorSteps withinRange(const ValueStyle& style, int steps)
{
	ColorSteps result;
	if (!style.bands.empty())
	{
		result.bounds = style.bands;
		for (std::size_t i = 0; i <= style.bands.size(); ++i)
			result.colors.push_back(style.bandColor(i));
		return result;
	}
	if (!(style.hi > style.lo))
		return {{}, {style.colors->at(0.5)}};
	for (int i = 0; i < steps; ++i)
	{
		if (i > 0)
			result.bounds.push_back(valueAt(style, i / double(steps)));
		result.colors.push_back(style.colors->at((i + 0.5) / steps));
	}
	return result;
}

} // namespace

std::size_t ColorSteps::at(double value) const
{
	return static_cast<std::size_t>(std::ranges::upper_bound(bounds, value) - bounds.begin());
}

bool ColorSteps::opaque() const
{
	return std::ranges::all_of(colors, [](const Color& color) { return color.a == 255; });
}

ColorSteps colorSteps(const ValueStyle& style, int steps)
{
	if (!style.colors->categories.empty())
	{
		CategorySteps categories = categorySteps(*style.colors);
		return {std::move(categories.bounds), std::move(categories.colors)};
	}
	ColorSteps result = withinRange(style, steps);
	if (style.below)
	{
		result.bounds.insert(result.bounds.begin(), style.lo);
		result.colors.insert(result.colors.begin(), style.belowColor());
	}
	if (style.above)
	{
		result.bounds.push_back(std::nextafter(style.hi, std::numeric_limits<double>::infinity()));
		result.colors.push_back(style.aboveColor());
	}
	return result;
}

} // namespace vp::render
