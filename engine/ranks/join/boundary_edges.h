#pragma once

#include "base/result.h"
#include "ranks/data/share.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::ranks
{

/// Where boundary faces meet at an angle (render::Outline::edges), of the blocks of all ranks: as one process has them,
/// which has joined the pieces of a lattice. All ranks call this together and get the same.
Result<std::vector<render::Segment>> boundaryEdgesOfAll(Team& team, const Share& share, const grid::BlockSet& blocks);

} // namespace vp::ranks
