#pragma once

#include "base/result.h"
#include "cut/cut.h"
#include "cut/request.h"
#include "refine/refiner.h"

#include <stop_token>

namespace vp::cut
{

/// Cuts blocks with curved cells: refines those that the sheets meet, then scans the parts. All of Cut::refined is new,
/// whatever an earlier cut has. Sections "refine" and those of a scan. Returns the error of find::planCut() where the
/// request has no such plan.
Result<Cut> cutRefined(refine::Refiner& refiner, const grid::BlockSet& blocks, const CutRequest& request,
                       const std::stop_token& stop);

} // namespace vp::cut
