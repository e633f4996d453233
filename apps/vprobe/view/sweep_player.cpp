#include "view/sweep_player.h"

#include "make_probe.h"

#include <fmt/format.h>

namespace vp::app
{

bool SweepPlayer::isPlaced(const ProbeOptions& options) const
{
	ProbeOptions placed = options;
	takePlace(placed, *placed_);
	if (over_times_)
		placed.time = placed_->time;
	return placed == options;
}

Status SweepPlayer::follow(const ViewState& state, const DatasetInfo& facts, double now)
{
	if (start_ && state.path == start_->path && isPlaced(state.probe))
	{
		// It stands where this sweep has put it; what else was changed holds from now on.
		ProbeOptions start = state.probe;
		takePlace(start, start_->probe);
		start.time = over_times_ ? start_->probe.time : start.time;
		start_->probe = start;
		return Nothing{};
	}
	PathOptions options = state.path;
	if (Status read = readPathFile(options); !read)
		return read;
	const probe::Path path = pathOf(options);
	over_times_ = options.overTimes();
	if (over_times_ && facts.times.empty())
		return Error{ErrorKind::usage, "the input has no times to play; choose another path"};
	if (!options.frames && !over_times_ && !probe::framesOf(path, options.per_second))
		options.frames = kFrames;
	Result<int> frames = over_times_ ? static_cast<int>(facts.times.size()) : frameCount(options, path);
	if (!frames)
		return frames.error();
	Result<probe::Probe> probe = makeProbe(state.probe, facts.bounds);
	if (!probe)
		return probe.error();
	poses_ = over_times_ ? std::vector<probe::Frame>() : probe::poses(path, *probe, facts.bounds, *frames);
	bounds_ = facts.bounds;
	start_ = state;
	placed_ = state.probe;
	player.setFrames(*frames, now);
	player.setSpeed(options.per_second, now);
	return Nothing{};
}

ViewState SweepPlayer::at(int frame, const ViewState& state)
{
	ViewState posed = state;
	posed.probe = start_->probe;
	if (over_times_)
		posed.probe.time = fmt::format("#{}", frame);
	else if (Result<probe::Probe> probe = makeProbe(start_->probe, bounds_))
	{
		probe::Probe moved = *probe;
		moved.frame = poses_[static_cast<std::size_t>(frame)];
		placeProbe(posed.probe, *probe, moved);
	}
	placed_ = posed.probe;
	return posed;
}

} // namespace vp::app
