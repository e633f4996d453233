#include "session/time_steps.h"

#include "session/session.h"
#include "session/sheet_traces.h"

#include <algorithm>

namespace vp::session
{

namespace
{

Status buildAnew(Session& session, read::ReadOptions at)
{
	// For one cut a time, neighbors do not pay. A rank without cells lacks nothing.
	const bool is_complete = !session.ranks.any(!grid::isComplete(session.blocks));
	at.builds_neighbors = is_complete && session.ranks.buildsWhileReading();
	Result<grid::BlockSet> blocks = readInputs(session, at);
	if (!blocks)
		return blocks.error();
	session.cutter.reset();
	session.blocks = std::move(*blocks);
	++session.stamp.grid;
	if (Status made = session.makeCutter(); !made)
		return made;
	return is_complete && !session.ranks.buildsWhileReading() ? session.buildNeighbors() : Nothing{};
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
	const Result<bool> same_grid =
	    ranks.keepsParts() ? read::readValues(spec.input.files, at, blocks, timeline.get()) : false;
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
