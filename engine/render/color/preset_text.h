#pragma once

#include "render/color/color_map.h"
#include "render/color/opacity_points.h"

#include <string>

namespace vp::render
{

/// Returns the text of a file with one preset of ParaView's, which readColorMap() reads to the same colors, opacities
/// and categories. points: those that made the opacities; without them each color has a point, unless all are opaque.
std::string presetText(const ColorMap& map, const OpacityPoints& points);

} // namespace vp::render
