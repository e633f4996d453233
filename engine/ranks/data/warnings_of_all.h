#pragma once

#include "ranks/team.h"
#include "read/read.h"

#include <vector>

namespace vp::ranks
{

// Returns what the readers of all ranks warn of, the same at every rank, in the order of the ranks. What several say in
// the same words of the same input is there once, with the sum of their counts.
std::vector<read::InputWarning> warningsOfAll(Team& team, const std::vector<read::InputWarning>& own);

} // namespace vp::ranks
