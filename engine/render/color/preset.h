#pragma once

#include "render/color/color_map.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace vp::render
{

// The color map that one of ParaView's presets describes, without its name. The error says what is wrong with the
// object and how it should be.
Result<ColorMap> colorMapOf(const nlohmann::json& preset);

// A name for legends and error lines: line breaks become blanks. Empty where there is no text.
std::string oneLine(const nlohmann::json& words);

} // namespace vp::render
