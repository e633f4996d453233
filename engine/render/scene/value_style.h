#pragma once

#include "render/scene/scene.h"

#include <cmath>
#include <string>
#include <vector>

namespace vp::render
{

constexpr Color kPlainSheet{142, 168, 195}; // where there is no array to show

// How values are shown, once data, look and a sheet's own wishes are known: what the legend tells and the composing
// pass does.
struct ValueStyle
{
	const ColorMap* colors = nullptr; // of the scene or the sheet
	double lo = 0.0;                  // values at the ends of the color map
	double hi = 1.0;
	bool logarithmic = false;
	bool per_cell = false;     // values are constant in each polygon
	bool below = false;        // values below lo get a color of their own
	bool above = false;        // and those above hi
	bool empty = false;        // lo and hi say nothing: there is no value
	std::vector<double> lines; // values of the contour lines, ascending
	std::vector<double> bands; // values between bands of color, ascending; empty: colors are continuous

	double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
	// 0 at lo, 1 at hi; a constant has the map's middle.
	double part(double value) const { return hi > lo ? (scaled(value) - scaled(lo)) / (scaled(hi) - scaled(lo)) : 0.5; }
	Color bandColor(std::size_t band) const; // of the band below bands[band], or above the last: that of its middle
};

ValueStyle valueStyle(const Look& look, const ValueScale& values);
ValueStyle valueStyle(const Scene& scene, const SheetDrawing& sheet); // of a scene, or a sheet, with values

ValueStyle valueStyle(const Scene& scene, const Surface& surface); // of a surface with values

// What a legend tells.
struct LegendContent
{
	std::string title;
	bool has_nan = false;
	ValueStyle style;
};

// The scene's, if any sheet goes by it (or there are none), then those of sheets with values, colors or a range of
// their own and of surfaces with values, each once. Legends of the same array are told apart by the sheets' or
// surfaces' numbers.
std::vector<LegendContent> legendContents(const Scene& scene);

// Bounds between the colors of categories, and those colors, one more: a value has the category that is nearest, no
// farther than half the way to the next one and 1/2; others have the NaN's color.
struct CategorySteps
{
	std::vector<double> bounds;
	std::vector<Color> colors;
};
CategorySteps categorySteps(const ColorMap& map);

} // namespace vp::render
