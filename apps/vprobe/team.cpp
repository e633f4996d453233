#include "team.h"

namespace vp::app
{

namespace
{

ranks::Team* the_team = nullptr;

} // namespace

ranks::Ranks processes()
{
	return ranks::Ranks(the_team);
}

void setTeam(ranks::Team* team)
{
	the_team = team;
}

bool isFirst()
{
	return processes().isFirst();
}

} // namespace vp::app
