#pragma once

#include "render/annotate/canvas.h"

#include <string>
#include <vector>

namespace vp::render
{

// Title and caption, where the layout has room for them.
void writeTitles(const Look& look, const Layout& layout, Canvas& pen);

// All that titles and legends may say, for FontAtlas.
std::vector<std::string> writtenTexts(const Look& look, const std::vector<LegendContent>& legends);

} // namespace vp::render
