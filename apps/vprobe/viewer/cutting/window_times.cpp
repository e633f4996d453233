#include "viewer/cutting/window_times.h"

#include "gpu/driver_name.h"
#include "options/trace_option.h"
#include "profile/spread.h"

#include <algorithm>
#include <utility>

namespace vp::app
{

namespace
{

// As many sections, and as many marks, take 5 MiB each: some minute of dragging.
constexpr std::size_t kKeptForTrace = 50'000;
constexpr std::size_t kFramesOfStages = 60; // as many as `vprobe profile` has planes

template <class Kept>
void keepLast(std::deque<Kept>& kept, std::size_t count)
{
	if (kept.size() > count)
		kept.erase(kept.begin(), kept.end() - static_cast<std::ptrdiff_t>(count));
}

} // namespace

WindowTimes::WindowTimes(std::optional<write::TraceFile> trace)
    : own_(trace ? Timeline::Keep::trace : Timeline::Keep::sections), trace_(std::move(trace))
{
}

WindowTimes::Sections WindowTimes::take(Timeline& timeline, double start)
{
	const Sections taken = timeline.takeSections();
	std::vector<Timeline::Mark> marks = timeline.takeMarks();
	Sections placed = taken;
	for (Timeline::Section& section : placed)
		section.start_ms += start;
	for (Timeline::Mark& mark : marks)
		mark.at_ms += start;
	const std::lock_guard lock(mutex_);
	sections_.insert(sections_.end(), placed.begin(), placed.end());
	marks_.insert(marks_.end(), marks.begin(), marks.end());
	keepLast(sections_, kKeptForTrace);
	keepLast(marks_, kKeptForTrace);
	if (trace_)
		trace_->add(std::move(placed), marks);
	return taken;
}

void WindowTimes::addFrame(std::vector<StageTime> stages)
{
	const std::lock_guard lock(mutex_);
	frames_.push_back(std::move(stages));
	keepLast(frames_, kFramesOfStages);
}

void WindowTimes::setDevice(const gpu::Device& device)
{
	const std::lock_guard lock(mutex_);
	device_ = device.name();
	driver_ = gpu::driverName(device);
}

void WindowTimes::setInputs(std::vector<std::string> inputs)
{
	const std::lock_guard lock(mutex_);
	inputs_ = std::move(inputs);
}

std::vector<StageFigure> WindowTimes::stages() const
{
	const std::lock_guard lock(mutex_);
	std::vector<StageFigure> figures;
	std::vector<std::vector<double>> ms; // per stage and frame; 0 where a frame has no such stage
	for (std::size_t f = 0; f < frames_.size(); ++f)
		for (const StageTime& stage : frames_[f])
		{
			const auto same = [&](const StageFigure& figure)
			{ return figure.track == stage.track && figure.name == stage.name; };
			const auto at = std::ranges::find_if(figures, same) - figures.begin();
			if (at == std::ssize(figures))
			{
				figures.push_back({stage.name, stage.track, stage.depth, 0.0, 0.0});
				ms.emplace_back(frames_.size(), 0.0);
			}
			ms[static_cast<std::size_t>(at)][f] = stage.ms;
		}
	for (std::size_t s = 0; s < figures.size(); ++s)
	{
		figures[s].last = ms[s].back();
		figures[s].median = medianOf(ms[s]);
	}
	return figures;
}

void WindowTimes::tell(write::TraceFile& trace) const
{
	const std::lock_guard lock(mutex_);
	trace.add({sections_.begin(), sections_.end()}, {marks_.begin(), marks_.end()});
	describeTrace(trace, inputs_, device_, driver_);
}

Status WindowTimes::commit()
{
	const std::lock_guard lock(mutex_);
	if (!trace_)
		return Nothing{};
	describeTrace(*trace_, inputs_, device_, driver_);
	Status written = trace_->commit();
	trace_.reset();
	return written;
}

} // namespace vp::app
