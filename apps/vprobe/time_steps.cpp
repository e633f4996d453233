#include "time_steps.h"

#include "sheet_traces.h"

namespace vp::app
{

namespace
{

Status buildAnew(Session& session, const ProbeOptions& options, read::ReadOptions at, Painter* painter)
{
	at.builds_neighbors = grid::hasNeighbors(session.blocks); // for one cut a time, neighbors do not pay
	Result<grid::BlockSet> blocks = read::readInputs(options.inputs, at, session.timeline.get());
	if (!blocks)
		return blocks.error();
	session.cutter.reset();
	session.blocks = std::move(*blocks);
	if (painter)
		if (Status taken = painter->takeBlocks(); !taken)
			return taken;
	return makeCutter(session, options);
}

} // namespace

Result<bool> moveToTime(Session& session, const ProbeOptions& options, const read::TimeChoice& time, Painter* painter)
{
	const read::ReadOptions at = readOptions(options, time);
	Result<bool> same_grid = read::readValues(options.inputs, at, session.blocks, session.timeline.get());
	if (!same_grid)
		return same_grid;
	if (painter)
		painter->forgetScales();
	if (*same_grid)
		session.cutter->forgetValues();
	else if (Status built = buildAnew(session, options, at, painter); !built)
		return built.error();
	takeValuesAt(time, session);
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

TimeSteps::TimeSteps(Session& session, const ProbeOptions& options, Painter* painter)
    : session_(session), options_(options), painter_(painter), times_(session.blocks.times)
{
}

Result<cut::Cut> TimeSteps::cutAt(int step)
{
	const read::TimeChoice time{read::TimeChoice::Kind::value, times_[static_cast<std::size_t>(step)]};
	Result<bool> same_grid = moveToTime(session_, options_, time, painter_);
	if (!same_grid)
		return same_grid.error();
	Result<cut::Cut> slice = *same_grid && kept_ && !session_.threshold && !cutsByValue(session_.probe)
	                             ? session_.cutter->regather(*kept_, session_.timeline.get())
	                             : cut(session_);
	if (slice)
		kept_ = *slice;
	return slice;
}

} // namespace vp::app
