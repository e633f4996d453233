#pragma once

#include "render/scene/outline.h"

#include <span>
#include <vector>

namespace vp::ranks
{

/// The outline of a curvilinear grid from the edges of its pieces, as the whole grid has it. Slabs that are stacked
/// along the last axis, one behind the other, are told by their curves. Of other pieces, edges count that one piece
/// alone has.
std::vector<render::Segment> outlineOfPieces(std::span<const render::EdgeCurves> pieces);

} // namespace vp::ranks
