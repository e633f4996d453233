#pragma once

#include "shared/render_types.h"

#include <cstdint>
#include <vector>

namespace vp::render
{

// A channel of a color each, 0 to 65535 for 0 to 1: red, green, blue, alpha.
using LayerColors = std::vector<std::uint16_t>;

// Adds the colors of a layer (see shared::kLayerBelow and those after it) that its parameters and the tables they
// point into come to, and gives their place: so a pixel's color is one texel.
std::uint32_t addLayerColors(LayerColors& to, const shared::SheetParams& sheet,
                             const std::vector<std::uint32_t>& tables);

} // namespace vp::render
