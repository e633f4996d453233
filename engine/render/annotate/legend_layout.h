#pragma once

#include "render/annotate/layout.h"

namespace vp::render
{

// Fills layout.legends. The text sizes and the margin of the layout must be set. A picture that is too small gets no
// legend.
void layOutLegends(const Look& look, const std::vector<LegendContent>& contents, Layout& layout);

} // namespace vp::render
