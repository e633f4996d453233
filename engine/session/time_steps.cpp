#include "session/time_steps.h"

#include "session/session.h"

#include <algorithm>

namespace vp::session
{

read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index)
{
	if (std::ranges::count(times, times[index]) > 1)
		return read::timeAt(index);
	return {read::TimeChoice::Kind::value, times[index]};
}

Status Session::goTo(const read::TimeChoice& time)
{
	const read::ReadOptions at = readOptions(time);
	const Result<bool> same_grid =
	    ranks_.keepsParts() ? read::readValues(inputs_, at, blocks_, timeline_.get()) : false;
	if (!same_grid)
		return same_grid.error();
	if (*same_grid)
		takeNewValues();
	else if (Status read = readAnew(at); !read)
		return read;
	takeValuesAt(time);
	return Nothing{};
}

Status Session::readAnew(read::ReadOptions at)
{
	// For one cut a time, neighbors do not pay. A rank without cells lacks nothing.
	const bool is_complete = !ranks_.any(!grid::isComplete(blocks_));
	at.builds_neighbors = is_complete && ranks_.buildsWhileReading();
	Result<grid::BlockSet> blocks = readInputs(at);
	if (!blocks)
		return blocks.error();
	cutter_.reset();
	blocks_ = std::move(*blocks);
	finite_fields_ = std::make_unique<measure::FiniteFields>();
	++stamp_.grid;
	if (Status made = makeCutter(); !made)
		return made;
	return is_complete && !ranks_.buildsWhileReading() ? buildNeighbors() : Nothing{};
}

} // namespace vp::session
