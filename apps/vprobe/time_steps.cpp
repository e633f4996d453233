#include "time_steps.h"

namespace vp::app
{

TimeSteps::TimeSteps(Session& session, const ProbeOptions& options, Painter* painter)
    : session_(session), options_(options), painter_(painter), times_(session.blocks.times)
{
}

Result<slice::Slice> TimeSteps::cutAt(int step)
{
	const read::ReadOptions at =
	    readOptions(options_, {read::TimeChoice::Kind::value, times_[static_cast<std::size_t>(step)]});
	Result<bool> same_grid = read::readValues(options_.inputs, at, session_.blocks, session_.timeline.get());
	if (!same_grid)
		return same_grid.error();
	if (painter_)
		painter_->forgetScales();
	if (*same_grid)
		session_.slicer->forgetValues();
	else if (Status built = buildAnew(at); !built)
		return built.error();
	Result<slice::Slice> slice = *same_grid && kept_ && !session_.threshold
	                                 ? session_.slicer->regather(*kept_, session_.timeline.get())
	                                 : cut(session_);
	if (slice)
		kept_ = *slice;
	return slice;
}

Status TimeSteps::buildAnew(const read::ReadOptions& at)
{
	Result<grid::BlockSet> blocks = read::readInputs(options_.inputs, at, session_.timeline.get());
	if (!blocks)
		return blocks.error();
	kept_.reset();
	session_.slicer.reset();
	session_.blocks = std::move(*blocks);
	if (painter_)
		if (Status taken = painter_->takeBlocks(); !taken)
			return taken;
	return makeSlicer(session_, options_);
}

} // namespace vp::app
