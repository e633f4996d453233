#pragma once

#include "render/color/color_map.h"
#include "viewer/panels/panels.h"

#include <string>

namespace vp::app
{

// Returns the map of a --colormap word, which is read only once. Returns null if there is no such map.
const render::ColorMap* colorMapOf(const std::string& word);

// These functions ask for the _r at the end of a word, and add or remove it.
bool isReversed(const std::string& word);
std::string otherWay(const std::string& word);

void drawGradient(ImDrawList& list, const render::ColorMap& map, const ImVec2& lo, const ImVec2& hi);

} // namespace vp::app
