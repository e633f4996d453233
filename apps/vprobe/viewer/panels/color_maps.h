#pragma once

#include "render/color/color_map.h"
#include "viewer/panels/panels.h"

#include <string>

namespace vp::app
{

// The map of a --colormap word, read once; null where it cannot be had.
const render::ColorMap* colorMapOf(const std::string& word);

// A word with or without _r behind it.
bool isReversed(const std::string& word);
std::string otherWay(const std::string& word);

void drawGradient(ImDrawList& list, const render::ColorMap& map, const ImVec2& lo, const ImVec2& hi);

} // namespace vp::app
