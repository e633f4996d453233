#pragma once

#include "render/annotate/pen.h"

namespace vp::render
{

// The colour bar (or the bands, or the categories), its marks and the array's name, where the layout has room for them.
void writeLegend(const LegendContent& content, const LegendLayout& layout, Pen& pen);

} // namespace vp::render
