#pragma once

#include "render/annotate/layout.h"

namespace vp::render
{

// Fills layout.legends, whose sizes of text and margin are known. None where a picture is too small for one.
void layOutLegends(const Look& look, const std::vector<LegendContent>& contents, Layout& layout);

} // namespace vp::render
