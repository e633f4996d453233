#pragma once

#include "render/color/color_map.h"

#include <span>

namespace vp::render
{

constexpr const char* kLabelsName = "labels"; // no setting names such a map

/// Returns a map of categories in colors that are easy to tell apart: those of K. L. Kelly, "Twenty-two colors of
/// maximum contrast", Color Engineering 3 (1965), without black, white and gray; then lighter and darker ones. 0, which
/// mostly means nothing, is light gray. values: ascending. If all of them are whole numbers from 0 to 19, each has its
/// own color, whatever others there are; otherwise they have colors in their order.
ColorMap labelColors(std::span<const double> values);

} // namespace vp::render
