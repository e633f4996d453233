#pragma once

#include "render/annotate/layout.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace vp::render
{

// A line that wants a label, in pixels with y down.
struct LabeledLine
{
	std::vector<glm::dvec2> points;
	bool closed = false;
	double width = 0.0; // of its label; 0: it wants none, and no other lies over it if that can be
};

// Where a label stands: on its line, along it, never upside down.
struct LabelPlace
{
	std::size_t line;
	glm::dvec2 center;
	double angle; // radians, clockwise as y is down; in [-pi/2, pi/2]
	double from;  // the part of the line it takes, as lengths from its start; of a closed line within one round
	double to;
};

// Places for labels of a height, the straightest and most upright parts of each line, one every `spacing` along it at
// most: within the area, off what is taken, where `seen` (a line and a place) says so, not over each other, and over
// other lines only where there is no better place. Lines hardly longer than their labels have none. Longer lines choose
// first.
std::vector<LabelPlace> placeLabels(std::span<const LabeledLine> lines, double height, double spacing,
                                    const Area& within, std::span<const Area> taken = {},
                                    const std::function<bool(std::size_t, const glm::dvec2&)>& seen = {});

// The parts of a line that its labels leave, as lines.
std::vector<std::vector<glm::dvec2>> withGaps(const LabeledLine& line, std::span<const LabelPlace> places);

} // namespace vp::render
