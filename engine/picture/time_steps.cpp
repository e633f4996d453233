#include "picture/time_steps.h"

#include "ranks/data/share.h"
#include "ranks/team.h"
#include "session/sheet_traces.h"

#include <algorithm>

namespace vp::picture
{

namespace
{

Status buildAnew(session::Session& session, read::ReadOptions at, Painter* painter)
{
	bool is_complete = grid::isComplete(session.blocks); // for one cut a time, neighbors do not pay
	if (session.team)                                    // a rank without cells lacks nothing
		is_complete = !ranks::anyOf(*session.team, !is_complete);
	at.builds_neighbors = is_complete && !session.team; // a rank joins its pieces first
	Result<grid::BlockSet> blocks = session::readInputs(session, at);
	if (!blocks)
		return blocks.error();
	session.cutter.reset();
	session.blocks = std::move(*blocks);
	if (painter)
		if (Status taken = painter->takeBlocks(); !taken)
			return taken;
	if (Status made = session::makeCutter(session); !made)
		return made;
	return is_complete && session.team ? session::buildNeighbors(session) : Nothing{};
}

} // namespace

read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index)
{
	if (std::ranges::count(times, times[index]) > 1)
		return read::timeAt(index);
	return {read::TimeChoice::Kind::value, times[index]};
}

Result<bool> moveToTime(session::Session& session, const read::TimeChoice& time, Painter* painter)
{
	const read::ReadOptions at = session::readOptions(session, time);
	// With a team, parts are dealt out anew: another time may have other pieces.
	Result<bool> same_grid =
	    session.team ? false : read::readValues(session.spec.input.files, at, session.blocks, session.timeline.get());
	if (!same_grid)
		return same_grid;
	if (painter)
		painter->forgetScales();
	if (*same_grid)
		session.cutter->forgetValues();
	else if (Status built = buildAnew(session, at, painter); !built)
		return built.error();
	session::takeValuesAt(time, session);
	return same_grid;
}

namespace
{

bool cutsByValue(const probe::Probe& probe)
{
	return std::ranges::any_of(probe.sheets,
	                           [](const probe::Sheet& sheet) { return sheet.form && sheet.form->isoValue(); });
}

} // namespace

TimeSteps::TimeSteps(session::Session& session, Painter* painter)
    : session_(session), painter_(painter), times_(session.blocks.times)
{
}

Result<cut::Cut> TimeSteps::cutAt(int step)
{
	const read::TimeChoice time = choiceOfStep(times_, static_cast<std::size_t>(step));
	Result<bool> same_grid = moveToTime(session_, time, painter_);
	if (!same_grid)
		return same_grid.error();
	Result<cut::Cut> slice =
	    *same_grid && kept_ && !kept_->refined && !session_.view.threshold && !cutsByValue(session_.view.probe)
	        ? session_.cutter->regather(*kept_, session_.timeline.get())
	        : session::cut(session_);
	if (slice)
		kept_ = *slice;
	return slice;
}

} // namespace vp::picture
