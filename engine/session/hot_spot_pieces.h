#pragma once

#include "cut/cutter.h"
#include "session/team.h"

#include <stop_token>

namespace vp::session
{

/// Cuts the pieces of the sheets that their hot spots lie in, which may go on in the parts of other ranks
/// (SeedMode::hotspot). The lowest rank that finds a hot spot begins. Each rank tells those beside it through which
/// faces its front goes out, and they go on from there, until no front is new. All ranks call this together.
Result<cut::Cut> cutHotSpotPieces(Team& team, cut::Cutter& cutter, cut::CutRequest request,
                                  const std::stop_token& stop);

/// With other seeds: whether a hot spot lies in the part of any rank.
void agreeOnHotSpots(Team& team, cut::Cut& cut);

} // namespace vp::session
