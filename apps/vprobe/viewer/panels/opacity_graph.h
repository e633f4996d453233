#pragma once

#include "render/color/color_map.h"
#include "render/color/opacity_points.h"
#include "viewer/panels/panels.h"

#include <span>

namespace vp::app
{

// The contents of the graph of an opacity by value.
struct OpacityGraph
{
	const render::ColorMap& map; // with the opacities of the points
	render::OpacityPoints points;
	std::size_t chosen;          // number of the chosen point
	std::span<const float> bars; // how often values occur, from the low end to the high end; 0 to 1 of the height
};

// A change by the mouse: a click chooses a point or adds one, a drag moves it, and the right button removes it.
enum class GraphChange
{
	none,
	chosen,  // another point is chosen
	edited,  // the points are others
	released // a drag has ended
};

// Draws the graph as wide as the line, and below it a strip of the colors. Changes the points as the mouse does.
GraphChange showOpacityGraph(const Desk& desk, OpacityGraph& graph);

} // namespace vp::app
