#pragma once

#include "cut/cut.h"
#include "grid/block.h"
#include "ranks/team.h"

#include <cstdint>
#include <span>

namespace vp::ranks
{

/// Drops faces in the sheets on which a cell of another rank lies, of packs whose runs the ranks share. They lie inside
/// the grid, and one process does not show them for themselves. whole: per block, the block that one process would have
/// in its place.
void dropFacesBetweenShares(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                            cut::Cut& cut);

} // namespace vp::ranks
