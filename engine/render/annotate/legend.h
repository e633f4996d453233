#pragma once

#include "render/annotate/canvas.h"

namespace vp::render
{

// The color bar (or the bands, or the categories), its marks and the array's name, where the layout has room for them.
void writeLegend(const LegendContent& content, const LegendLayout& layout, Canvas& pen);

} // namespace vp::render
