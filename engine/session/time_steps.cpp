#include "session/time_steps.h"

#include "base/messages.h"
#include "ranks/data/share.h"
#include "session/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace vp::session
{

read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index)
{
	if (std::ranges::count(times, times[index]) > 1)
		return read::timeAt(index);
	return {read::TimeChoice::Kind::value, times[index]};
}

std::string timeText(const Session& session)
{
	const std::optional<double> time = session.time();
	if (!time)
		return {};
	constexpr int kDigits = 6;
	std::vector<double> others = session.blocks().times;
	std::erase(others, *time);
	std::string number;
	for (int digits = kDigits; digits <= std::numeric_limits<double>::max_digits10; ++digits)
	{
		number = fmt::format("{:.{}g}", *time, digits);
		if (std::ranges::none_of(others, [&](double other) { return fmt::format("{:.{}g}", other, digits) == number; }))
			break;
	}
	const std::string& units = session.blocks().time_units;
	return fmt::format("t = {}{}{}", number, units.empty() ? "" : " ", units);
}

Status Session::goTo(const read::TimeChoice& time)
try
{
	const read::ReadOptions at = readOptions(time);
	const std::size_t step = read::timeIndex(blocks_.times, time);
	Result<bool> same_grid = ranks::hasTimeInRuns(ranks_, blocks_, step);
	const bool is_in_runs = *same_grid;
	if (!is_in_runs && ranks_.keepsParts())
	{
		read::ReadAhead readers = step_ahead_.take(inputs_, at, blocks_.times);
		same_grid = read::readValues(readers, inputs_.size(), blocks_, timeline_.get());
	}
	if (!same_grid)
		return same_grid.error();
	const auto next = step_ahead_.nextAfter(step, blocks_.times.size());
	if (is_in_runs) // frames read the values of what they meet
		for (grid::Block& block : blocks_.blocks)
		{
			if (block.runs)
				block.runs->goTo(step, next, block);
		}
	else if (*same_grid && next && mayReadAhead(blocks_))
		step_ahead_.expect(inputs_, readOptions(choiceOfStep(blocks_.times, *next)), *next);
	if (*same_grid)
	{
		lookForCategories();
		takeNewValues();
	}
	else if (Status read = readAnew(at); !read)
		return read;
	takeValuesAt(time);
	return Nothing{};
}
catch (const parts::Unreadable& unreadable)
{
	return Error{ErrorKind::input, unreadable.what()};
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
	lookForCategories();
	finite_fields_ = std::make_unique<measure::FiniteFields>();
	++stamp_.grid;
	if (Status made = makeCutter(); !made)
		return made;
	return is_complete && !ranks_.buildsWhileReading() ? buildNeighbors() : Nothing{};
}

Status Session::readUndivided()
{
	if (ranks_.isFirst())
		warn("cells of different sizes meet between two processes, so one of them reads all of the pack; vprobe reads "
		     "less");
	if (Status read = readAnew(readOptions(spec_.input.time)); !read)
		return read;
	takeValuesAt(spec_.input.time);
	return Nothing{};
}

} // namespace vp::session
