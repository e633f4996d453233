#include "team.h"

#include "ranks/team.h"

namespace vp::app
{

namespace
{

ranks::Team* the_team = nullptr;

} // namespace

ranks::Team* team()
{
	return the_team;
}

void setTeam(ranks::Team* team)
{
	the_team = team;
}

bool isFirst()
{
	return !the_team || the_team->isFirst();
}

} // namespace vp::app
