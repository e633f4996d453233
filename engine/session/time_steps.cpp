#include "session/time_steps.h"

#include "ranks/data/share.h"
#include "ranks/team.h"
#include "session/session.h"
#include "session/sheet_traces.h"

#include <algorithm>

namespace vp::session
{

namespace
{

Status buildAnew(Session& session, read::ReadOptions at)
{
	bool is_complete = grid::isComplete(session.blocks); // for one cut a time, neighbors do not pay
	if (session.team)                                    // a rank without cells lacks nothing
		is_complete = !ranks::anyOf(*session.team, !is_complete);
	at.builds_neighbors = is_complete && !session.team; // a rank joins its pieces first
	Result<grid::BlockSet> blocks = readInputs(session, at);
	if (!blocks)
		return blocks.error();
	session.cutter.reset();
	session.blocks = std::move(*blocks);
	++session.stamp.grid;
	if (Status made = session.makeCutter(); !made)
		return made;
	return is_complete && session.team ? session.buildNeighbors() : Nothing{};
}

} // namespace

read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index)
{
	if (std::ranges::count(times, times[index]) > 1)
		return read::timeAt(index);
	return {read::TimeChoice::Kind::value, times[index]};
}

Status Session::goTo(const read::TimeChoice& time)
{
	const read::ReadOptions at = readOptions(*this, time);
	// With a team, parts are dealt out anew: another time may have other pieces.
	const Result<bool> same_grid = team ? false : read::readValues(spec.input.files, at, blocks, timeline.get());
	if (!same_grid)
		return same_grid.error();
	if (*same_grid)
		forgetValues();
	else if (Status built = buildAnew(*this, at); !built)
		return built;
	takeValuesAt(time, *this);
	return Nothing{};
}

} // namespace vp::session
