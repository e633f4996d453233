#include "viewer/document/sweep_player.h"

#include "view/resolve.h"

namespace vp::app
{

bool SweepPlayer::isPlaced(const view::ViewSpec& state) const
{
	view::ProbeSpec placed = state.probe;
	takePlace(placed, placed_->probe);
	return placed == state.probe && (!over_times_ || state.input.time == placed_->input.time);
}

Status SweepPlayer::follow(const view::ViewSpec& state, const DatasetInfo& facts, double now)
{
	if (start_ && state.sweep == start_->sweep && isPlaced(state))
	{
		// The probe stands where this sweep has put it. Other changes apply from now on.
		view::ViewSpec start = state;
		takePlace(start.probe, start_->probe);
		if (over_times_)
			start.input.time = start_->input.time;
		start_->probe = start.probe;
		start_->input = start.input;
		return Nothing{};
	}
	view::SweepSpec sweep = state.sweep;
	const probe::Path path = view::pathOf(sweep);
	over_times_ = sweep.over_times;
	if (over_times_ && facts.times.empty())
		return Error{ErrorKind::usage, "the input has no times to play; choose another path"};
	if (!sweep.frames && !over_times_ && !probe::framesOf(path, view::framesPerSecond(sweep)))
		sweep.frames = kFrames;
	const Result<int> frames = over_times_ ? static_cast<int>(facts.times.size()) : view::frameCount(sweep);
	if (!frames)
		return frames.error();
	const probe::Probe probe = view::makeProbe(state.probe, facts.bounds);
	poses_ = over_times_ ? std::vector<probe::Frame>() : probe::poses(path, probe, facts.bounds, *frames);
	bounds_ = facts.bounds;
	start_ = state;
	placed_ = state;
	player.setFrames(*frames, now);
	player.setSpeed(view::framesPerSecond(sweep), now);
	return Nothing{};
}

view::ViewSpec SweepPlayer::at(int frame, const view::ViewSpec& state)
{
	view::ViewSpec posed = state;
	posed.probe = start_->probe;
	posed.input = start_->input;
	if (over_times_)
		posed.input.time = read::timeAt(static_cast<std::size_t>(frame));
	else
	{
		const probe::Probe probe = view::makeProbe(start_->probe, bounds_);
		probe::Probe moved = probe;
		moved.frame = poses_[static_cast<std::size_t>(frame)];
		placeProbe(posed.probe, probe, moved);
	}
	placed_ = posed;
	return posed;
}

} // namespace vp::app
