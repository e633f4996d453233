#pragma once

#include "render/annotate/canvas.h"

namespace vp::render
{

// Draws the color bar (or the bands, or the categories), its marks and the name of the array, as far as the layout has
// room for them.
void writeLegend(const LegendContent& content, const LegendLayout& layout, Canvas& pen);

} // namespace vp::render
