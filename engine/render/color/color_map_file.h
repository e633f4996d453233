#pragma once

#include "render/color/color_map.h"

#include <string>
#include <string_view>

namespace vp::render
{

// Returns the color map that --colormap names: one of ours or FILE.json[:PRESET], either with _r at the end for the
// reverse. An unknown name is a usage error, and an unusable file is an input error. Both are one line with the remedy.
Result<ColorMap> chooseColorMap(const std::string& text);

// ParaView's presets: an object, or an array of them, from which `preset` chooses by Name (empty: there must be one).
// RGBPoints (x, r, g, b …) and ColorSpace make the colors, Points (x, alpha, midpoint, sharpness …) an opacity by
// value unless EnableOpacityMapping is false; IndexedColors (r, g, b …) and Annotations (value, name …) make
// categories. NanColor, BelowRangeColor and AboveRangeColor are taken over. x are places between the ends, not values:
// the range of the colors is the data's or the user's.
Result<ColorMap> readColorMap(const std::string& file, const std::string& preset = {});
Result<ColorMap> parseColorMap(std::string_view text, const std::string& file, const std::string& preset = {});

} // namespace vp::render
