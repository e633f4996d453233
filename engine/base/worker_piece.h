#pragma once

#include "base/timeline.h"

#include <string_view>

namespace vp
{

// A parallel loop whose workers appear in a trace, each in a row of its own, under the name of the section in which the
// loop was called. A thread that calls a loop makes this. If nothing is traced, a part of the loop costs one test.
class TracedLoop
{
public:
	TracedLoop() : timeline_(Timeline::tracingHere()), name_(timeline_ ? openSection().name : std::string_view()) {}

	Timeline* timeline() const { return timeline_; } // null if nothing is traced
	std::string_view name() const { return name_; }

private:
	Timeline* timeline_;
	std::string_view name_;
};

// A part of a loop. The thread that called the loop has a section already, so its parts do not count.
class WorkerPiece
{
public:
	explicit WorkerPiece(const TracedLoop& loop)
	{
		if (loop.timeline()) [[unlikely]]
			begin(loop);
	}
	~WorkerPiece()
	{
		if (timeline_) [[unlikely]]
			end();
	}
	WorkerPiece(const WorkerPiece&) = delete;
	WorkerPiece& operator=(const WorkerPiece&) = delete;

private:
	void begin(const TracedLoop& loop);
	void end();

	Timeline* timeline_ = nullptr;
	double start_ = 0.0;
};

} // namespace vp
