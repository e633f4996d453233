#pragma once

#include "cut/cutter.h"
#include "ranks/team.h"

#include <cstdint>
#include <span>
#include <stop_token>

namespace vp::ranks
{

/// Whether what a cut finds depends on where its search begins, so that it must go on from rank to rank: at hot spots
/// alone, at the boundary alone where a sheet is no plane, or in a plane where the search ends at cells outside a
/// threshold.
bool goesFromRankToRank(const cut::CutRequest& request);

/// Cuts as one process does that has the parts of all ranks. The search begins at the boundary that this has, and at
/// the hot spots: the lowest rank that finds one begins. Each rank tells those beside it through which faces its front
/// goes out, and they go on from there, until no front is new. All ranks call this together.
///
/// whole: per block, the block that one process would have in its place.
Result<cut::Cut> cutFromRankToRank(Team& team, std::span<const std::uint32_t> whole, cut::Cutter& cutter,
                                   cut::CutRequest request, const std::stop_token& stop);

/// With other seeds: whether a hot spot lies in the part of any rank.
void agreeOnHotSpots(Team& team, cut::Cut& cut);

} // namespace vp::ranks
