#pragma once

#include "base/timeline.h"
#include "gpu/device.h"
#include "profile/profile_log.h"
#include "write/trace_file.h"

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// The time of a stage of the work, over the last frames. The names are those of `vprobe profile`.
struct StageFigure
{
	std::string name;
	Timeline::Track track;
	std::uint32_t depth; // number of stages around it; 0 for stages on the GPU
	double last;         // ms
	double median;       // ms, over the last frames
};

// Knows where the time of a window goes. Every session has a timeline of its own, and the work of the window itself,
// such as opening its device and showing frames, has another one. Here all of them are on one time axis. Thread safe.
class WindowTimes
{
public:
	using Sections = std::vector<Timeline::Section>;

	// trace: takes everything until the window closes. Without it, about the last minute is kept.
	explicit WindowTimes(std::optional<write::TraceFile> trace);

	// The timelines of sessions are to keep so much.
	Timeline::Keep keep() const { return own_.traces() ? Timeline::Keep::trace : Timeline::Keep::sections; }
	Timeline& own() { return own_; } // for the window's thread
	// Returns the start of another timeline on the time axis of the window, in milliseconds.
	double startOf(const Timeline& timeline) const { return own_.now() - timeline.now(); }
	// Takes what a timeline has kept since the last call. Returns its sections, on its own time axis.
	Sections take(Timeline& timeline, double start);
	// Counts the stages of a frame.
	void addFrame(std::vector<StageTime> stages);
	void setDevice(const gpu::Device& device);
	void setInputs(std::vector<std::string> inputs); // those that the window shows

	std::vector<StageFigure> stages() const; // in the order in which they begin
	// Puts what is known of about the last minute into a trace.
	void tell(write::TraceFile& trace) const;
	// Puts the trace of the whole window, if there is one, into its place.
	Status commit();

private:
	Timeline own_;
	mutable std::mutex mutex_;
	std::optional<write::TraceFile> trace_;
	std::deque<Timeline::Section> sections_; // of about the last minute
	std::deque<Timeline::Mark> marks_;
	std::deque<std::vector<StageTime>> frames_; // the last ones
	std::vector<std::string> inputs_;
	std::string device_ = "none";
	std::string driver_ = "none";
};

} // namespace vp::app
