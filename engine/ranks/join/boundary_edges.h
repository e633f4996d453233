#pragma once

#include "base/result.h"
#include "ranks/data/share.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::ranks
{

/// Returns the edges at which boundary faces of all ranks' blocks meet at an angle (render::Outline::edges). They are
/// the same as in one process, which joins the pieces of a lattice. All ranks must call this together, and get the same
/// result.
Result<std::vector<render::Segment>> boundaryEdgesOfAll(Team& team, const Share& share, const grid::BlockSet& blocks);

} // namespace vp::ranks
