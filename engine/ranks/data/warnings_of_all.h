#pragma once

#include "ranks/team.h"
#include "read/read.h"

#include <vector>

namespace vp::ranks
{

// Returns the warnings of all ranks' readers, in the order of the ranks. All ranks get the same. Where several say the
// same of one input it is there once, with the sum of their counts. A part is read by one rank, so nothing counts
// twice.
std::vector<read::InputWarning> warningsOfAll(Team& team, const std::vector<read::InputWarning>& own);

} // namespace vp::ranks
