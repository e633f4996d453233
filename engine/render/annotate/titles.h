#pragma once

#include "render/annotate/canvas.h"

#include <string>
#include <vector>

namespace vp::render
{

// Writes title and caption, if the layout has room for them.
void writeTitles(const Look& look, const Layout& layout, Canvas& pen);

// Returns all text that titles and legends may contain, for FontAtlas.
std::vector<std::string> writtenTexts(const Look& look, const std::vector<LegendContent>& legends);

} // namespace vp::render
