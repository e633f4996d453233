#pragma once

#include "cut/cutter.h"
#include "ranks/ranks.h"

#include <stop_token>

namespace vp::ranks
{

/// Returns true if what a cut finds depends on where its search begins, so that it must go on from rank to rank: at hot
/// spots alone, at the boundary alone where a sheet is no plane, or in a plane where the search ends at cells outside a
/// threshold.
bool goesFromRankToRank(const cut::CutRequest& request);

/// Cuts as one process does that has the parts of all ranks; each gets what lies in its part.
///
/// If the search must go from rank to rank, it begins at the boundary that the whole has, and at the hot spots: the
/// lowest rank that finds one begins. Each rank tells those beside it through which faces its front goes out, and they
/// go on from there, until no front is new. Otherwise each rank finds what it has by itself, and the ranks agree
/// whether a hot spot lies in the part of any.
Result<cut::Cut> carryOut(const Ranks& ranks, cut::Cutter& cutter, cut::CutRequest request,
                          const std::stop_token& stop);

} // namespace vp::ranks
