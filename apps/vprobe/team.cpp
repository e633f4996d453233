#include "team.h"

#include "session/team.h"

namespace vp::app
{

namespace
{

session::Team* the_team = nullptr;

} // namespace

session::Team* team()
{
	return the_team;
}

void setTeam(session::Team* team)
{
	the_team = team;
}

bool isFirst()
{
	return !the_team || the_team->isFirst();
}

} // namespace vp::app
