#include "api/border.h"
#include "api/states.h"
#include "probe/path.h"
#include "session/time_steps.h"
#include "view/validate.h"

#include <vprobe/dataset.h>

#include <fmt/format.h>

namespace vprobe
{

namespace
{

// The frames of a sweep by the settings that were taken last. The mutex is held.
class Frames
{
public:
	static vp::Result<Frames> of(DatasetState& state)
	{
		const vp::session::Session& session = *state.session;
		const vp::view::SweepSpec& sweep = session.spec().sweep;
		Frames frames(state);
		if (sweep.over_times)
		{
			frames.count_ = static_cast<int>(session.blocks().times.size());
			if (frames.count_ == 0)
				return vp::Error{vp::ErrorKind::usage, "`path` times: the input has no times; choose another path"};
			return frames;
		}
		if (vp::Status fits = vp::view::requirePathOfSurface(session.spec().probe, sweep); !fits)
			return fits.error();
		const vp::Result<int> count = vp::view::frameCount(sweep);
		if (!count)
			return count.error();
		frames.count_ = *count;
		frames.path_ = vp::view::pathOf(sweep);
		frames.poses_ = vp::probe::poses(frames.path_, session.view().probe, session.blocks().bounds(), *count);
		return frames;
	}

	int count() const { return count_; }

	vp::Result<SweepFrame> at(int index, bool draws, const std::stop_token& stop)
	{
		if (stop.stop_requested())
			return vp::Error{vp::ErrorKind::cancelled, "the caller asked to stop"};
		SweepFrame frame{.index = index, .count = count_, .time = {}, .cut = {}, .image = {}};
		if (vp::Status moved = poses_.empty() ? moveInTime(index, frame) : moveProbe(index); !moved)
			return moved.error();
		vp::Result<Cut> cut = state_.cut(stop);
		if (!cut)
			return cut.error();
		frame.cut = std::move(*cut);
		if (draws)
		{
			vp::Result<Image> image = state_.draw(frame.cut, stop);
			if (!image)
				return image.error();
			frame.image = std::move(*image);
		}
		return frame;
	}

private:
	explicit Frames(DatasetState& state) : state_(state) {}

	vp::Status moveProbe(int index)
	{
		state_.request.pose = poses_[static_cast<std::size_t>(index)];
		state_.request.done = vp::probe::progress(path_, index, count_);
		return vp::Nothing{};
	}

	vp::Status moveInTime(int index, SweepFrame& frame)
	{
		vp::session::Session& session = *state_.session;
		const vp::read::TimeChoice time =
		    vp::session::choiceOfStep(session.blocks().times, static_cast<std::size_t>(index));
		frame.time = session.blocks().times[static_cast<std::size_t>(index)];
		if (state_.moved_to == time)
			return vp::Nothing{};
		state_.moved_to = time; // also where it fails half way
		return state_.moveTo(time);
	}

	DatasetState& state_;
	int count_ = 0;
	vp::probe::Path path_;
	std::vector<vp::probe::Frame> poses_; // none where the times go by
};

} // namespace

Status Dataset::sweep(const View& view, const std::function<bool(const SweepFrame&)>& on_frame, bool draws,
                      std::stop_token stop) const
{
	const auto all = [&]() -> vp::Result<Nothing>
	{
		vp::Result<Frames> frames = Frames::of(*state_);
		if (!frames)
			return frames.error();
		for (int k = 0; k < frames->count(); ++k)
		{
			const vp::Result<SweepFrame> frame = frames->at(k, draws, stop);
			if (!frame)
				return frame.error();
			if (!on_frame(*frame))
				break;
		}
		return Nothing{};
	};
	return withView<Nothing>(*state_, view, all, true);
}

Result<SweepFrame> Dataset::frame(const View& view, int index, bool draws, std::stop_token stop) const
{
	const auto one = [&]() -> vp::Result<SweepFrame>
	{
		vp::Result<Frames> frames = Frames::of(*state_);
		if (!frames)
			return frames.error();
		if (index < 0 || index >= frames->count())
			return vp::Error{vp::ErrorKind::usage,
			                 fmt::format("frame {}: the sweep has {}, from 0", index, frames->count())};
		return frames->at(index, draws, stop);
	};
	return withView<SweepFrame>(*state_, view, one, true);
}

} // namespace vprobe
