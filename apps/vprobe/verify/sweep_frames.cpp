#include "verify/sweep_frames.h"

#include "session/time_steps.h"
#include "view/validate.h"

#include <fmt/format.h>

namespace vp::app
{

Result<SweepFrames> SweepFrames::of(const session::Session& session)
{
	const view::SweepSpec& sweep = session.spec().sweep;
	if (Status fits = view::requirePathOfSurface(session.spec().probe, sweep); !fits)
		return fits.error();
	SweepFrames frames;
	if (sweep.over_times)
		frames.times_ = session.blocks().times;
	if (sweep.over_times && frames.times_.empty())
		return Error{ErrorKind::input,
		             fmt::format("{}: has no times to sweep over", session.spec().input.files.front())};
	const Result<int> count =
	    sweep.over_times ? Result<int>(static_cast<int>(frames.times_.size())) : view::frameCount(sweep);
	if (!count)
		return count.error();
	frames.numbers_ = {0, *count / 2, *count - 1};
	if (sweep.over_times)
	{
		frames.requests_.resize(kEndings.size());
		return frames;
	}
	const probe::Path path = view::pathOf(sweep);
	const std::vector<probe::Frame> poses = probe::poses(path, session.view().probe, session.blocks().bounds(), *count);
	for (const int number : frames.numbers_)
		frames.requests_.push_back(
		    {.pose = poses[static_cast<std::size_t>(number)], .done = probe::progress(path, number, *count)});
	return frames;
}

Status SweepFrames::goTo(session::Session& session, std::size_t which) const
{
	if (!isOverTimes())
		return Nothing{};
	return session.goTo(session::choiceOfStep(times_, static_cast<std::size_t>(numbers_[which])));
}

session::FrameRequest SweepFrames::request(std::size_t which) const
{
	return requests_[which];
}

} // namespace vp::app
