#pragma once

#include "render/flat/cairo_canvas.h"
#include "render/flat/flat_layout.h"
#include "render/scene/color_steps.h"

namespace vp::render
{

// The parts of a flat picture, from below to above.

void paintBackground(const Look& look, cairo_t* context);

// Draws the sheet's colors, mesh and contour lines inside the plot.
void drawFlatSheet(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen);

// Draws a frame around the plot, with numbers and the names of the axes.
void drawFlatAxes(const FlatLayout& layout, CairoCanvas& pen);

// Draws the letters at the rims of the plot, inside.
void drawSides(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen);

// Draws the small view: where the sheet lies in the grid.
void drawSmallView(const FlatScene& flat, const FlatLayout& layout, CairoCanvas& pen);

} // namespace vp::render
