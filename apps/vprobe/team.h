#pragma once

namespace vp::ranks
{
class Team;
}

namespace vp::app
{

// The processes that carry out a command together, or null for one process alone. vprobe-mpi sets it.
ranks::Team* team();
void setTeam(ranks::Team* team);

// True for the process that writes and prints: the only one, or the first of a team.
bool isFirst();

} // namespace vp::app
