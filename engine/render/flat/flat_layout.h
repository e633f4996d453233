#pragma once

#include "render/annotate/font_atlas.h"
#include "render/annotate/layout.h"
#include "render/flat/flat_scene.h"

#include <array>
#include <string>

namespace vp::render
{

// The meaning of the numbers along an axis of a sheet. If the axis is parallel to x, y or z, they are that coordinate,
// else the distance from the sheet's origin. At the sheet's coordinate c the number is at_origin + sign * c.
struct PlaneAxis
{
	std::string title;
	double at_origin = 0.0;
	double sign = 1.0;
	Ticks ticks{};

	double coordinate(double value) const { return sign * (value - at_origin); }
};

// Returns the axis without ticks. direction: the sheet's x axis or up, a unit vector. units: of length, or empty.
PlaneAxis planeAxis(const Vec3& origin, const Vec3& direction, const std::string& units);

struct FlatLayout
{
	Layout text;  // title, caption, legends
	Area plot;    // pixels
	Area shown;   // the sheet's coordinates in the plot, y up
	double scale; // pixels to a unit, along both axes
	std::array<PlaneAxis, 2> axes;
	double widest_number; // widest number of the upright axis, pixels
	Area small;           // the small view of the grid

	glm::dvec2 pixel(const glm::dvec2& uv) const
	{
		return {plot.lo.x + scale * (uv.x - shown.lo.x), plot.hi.y - scale * (uv.y - shown.lo.y)};
	}
};

constexpr double kFlatTick = 0.35; // em, outwards
constexpr double kFlatGap = 0.3;   // em, between ticks, numbers and titles

// The layout has the text sizes of makeLayout(). `lettering` must have them.
FlatLayout makeFlatLayout(const FlatScene& flat, const std::vector<LegendContent>& legends, const Layout& text,
                          const FontAtlas& lettering);

} // namespace vp::render
