#pragma once

#include "render/annotate/layout.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace vp::render
{

// A line that gets labels, in pixels with y down.
struct LabeledLine
{
	std::vector<glm::dvec2> points;
	bool closed = false;
	double width = 0.0; // width of its label; 0: it gets no label, and other labels avoid it if they can
};

// The place of a label: on its line, along it, never upside down.
struct LabelPlace
{
	std::size_t line;
	glm::dvec2 center;
	double angle; // radians, clockwise as y is down; in [-pi/2, pi/2]
	double from;  // the part of the line that it covers, as lengths from its start; at most once around a closed line
	double to;
};

// Returns places for labels of a height. They are on the straightest and most upright parts of each line, at least
// `spacing` apart along it. They lie inside the area, outside the taken areas, where `seen` (a line and a place) allows
// it, and not over each other. They lie over other lines only if there is no better place. A line hardly longer than
// its label gets none. Longer lines choose first.
std::vector<LabelPlace> placeLabels(std::span<const LabeledLine> lines, double height, double spacing,
                                    const Area& within, std::span<const Area> taken = {},
                                    const std::function<bool(std::size_t, const glm::dvec2&)>& seen = {});

// Returns the parts of a line that its labels do not cover, as lines.
std::vector<std::vector<glm::dvec2>> withGaps(const LabeledLine& line, std::span<const LabelPlace> places);

} // namespace vp::render
