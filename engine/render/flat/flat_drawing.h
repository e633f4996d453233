#pragma once

#include "render/flat/cairo_pen.h"
#include "render/flat/flat_layout.h"
#include "render/scene/color_steps.h"

namespace vp::render
{

// The parts of a flat picture, from below to above.

void paintBackground(const Look& look, cairo_t* context);

// The sheet's colours, mesh and contour lines, within the plot.
void drawFlatSheet(const FlatScene& flat, const FlatLayout& layout, CairoPen& pen);

// A frame around the plot, with numbers and the axes' names.
void drawFlatAxes(const FlatLayout& layout, CairoPen& pen);

// Where the sheet lies in the grid.
void drawSmallView(const FlatScene& flat, const FlatLayout& layout, CairoPen& pen);

} // namespace vp::render
