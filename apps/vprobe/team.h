#pragma once

#include "ranks/ranks.h"

namespace vp::app
{

// The processes that carry out a command together: one alone, or the team that vprobe-mpi sets.
ranks::Ranks processes();
void setTeam(ranks::Team* team);

// True for the process that writes and prints.
bool isFirst();

} // namespace vp::app
