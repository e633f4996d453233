#pragma once

#include "render/annotate/ticks.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "render/scene/value_style.h"

#include <glm/vec2.hpp>

#include <vector>

namespace vp::render
{

constexpr double kLineHeight = 1.25; // height of a line of text, in em

struct Area
{
	glm::dvec2 lo{0.0};
	glm::dvec2 hi{0.0};

	glm::dvec2 size() const { return hi - lo; }
	bool overlaps(const Area& other) const
	{
		return lo.x < other.hi.x && other.lo.x < hi.x && lo.y < other.hi.y && other.lo.y < hi.y;
	}
};

// The column of a legend, and its parts from top to bottom.
struct LegendLayout
{
	Area column;
	Area title;
	Area factor;
	Area bar; // without the caps; for categories, the column of their colors
	Area nan;
	double cap; // height of the pointed ends for values beyond the range, 0 if there are none
	Ticks ticks;
	std::size_t categories; // number of categories that fit; a line below says how many are left out
	double entry;           // height of a category's line
};

// The places of everything that is written into a picture, in pixels from the top left. An item that is off has no
// area.
struct Layout
{
	double em;       // size of plain text
	double title_em; // size of the picture's title
	double small_em; // size of the caption
	double margin;

	Area title;
	Area caption;
	Area axes;
	std::vector<LegendLayout> legends; // legends of the first contents that fit, from top to bottom; may be empty

	Frame frame;
};

Layout makeLayout(const Look& look, const std::vector<LegendContent>& legends);
Layout makeLayout(const Scene& scene);

} // namespace vp::render
