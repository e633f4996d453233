#pragma once

#include "render/flat/cairo_canvas.h"
#include "render/flat/flat_layout.h"
#include "render/scene/color_steps.h"

namespace vp::render
{

// The parts of a flat picture, from below to above.

void paintBackground(const Look& look, cairo_t* context);

// The sheet's colors, mesh and contour lines, within the plot.
void drawFlatSheet(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen);

// A frame around the plot, with numbers and the axes' names.
void drawFlatAxes(const FlatLayout& layout, CairoCanvas& pen);

// Where the sheet lies in the grid.
void drawSmallView(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen);

} // namespace vp::render
