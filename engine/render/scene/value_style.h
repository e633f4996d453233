#pragma once

#include "render/scene/scene.h"

#include <cmath>
#include <string>
#include <vector>

namespace vp::render
{

constexpr Color kPlainSheet{142, 168, 195}; // without an array

// How values are shown. It follows from the data, the look and the settings of a sheet. The legend and the composing
// pass use it.
struct ValueStyle
{
	const ColorMap* colors = nullptr; // colors of the scene or the sheet
	double lo = 0.0;                  // values at the ends of the color map
	double hi = 1.0;
	bool logarithmic = false;
	bool per_cell = false;     // values are constant in each polygon
	bool below = false;        // there may be values below lo
	bool above = false;        // there may be values above hi
	bool marks = false;        // such values have the map's colors for them, not those of its ends
	bool empty = false;        // there is no value, so lo and hi mean nothing
	std::vector<double> lines; // values of the contour lines, ascending
	std::vector<double> bands; // values between bands of color, ascending; empty: colors are continuous

	double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
	// Returns 0 at lo and 1 at hi. A constant gets the middle of the map.
	double part(double value) const { return hi > lo ? (scaled(value) - scaled(lo)) / (scaled(hi) - scaled(lo)) : 0.5; }
	Color belowColor() const; // color of values below lo
	Color aboveColor() const;
	Color bandColor(std::size_t band) const; // color in the middle of the band below bands[band], or above the last
};

ValueStyle valueStyle(const Look& look, const ValueScale& values);
ValueStyle valueStyle(const Scene& scene, const SheetDrawing& sheet); // for a scene or a sheet with values

ValueStyle valueStyle(const Scene& scene, const Surface& surface); // for a surface with values

// The content of a legend.
struct LegendContent
{
	std::string title;
	bool has_nan = false;
	ValueStyle style;
};

// Returns the contents of all legends, each once: that of the scene, if a sheet uses it or there are no sheets, then
// those of sheets with their own values, colors or range, and of surfaces with values. Numbers of sheets or surfaces
// distinguish legends of the same array.
std::vector<LegendContent> legendContents(const Scene& scene);

// Returns the colors of categories and the bounds between them. A value belongs to the nearest category if it is at
// most 1/2, and half of the way to the next one, away. Other values have the color of NaN.
struct CategorySteps
{
	std::vector<double> bounds;
	std::vector<Color> colors;
};
CategorySteps categorySteps(const ColorMap& map);

} // namespace vp::render
