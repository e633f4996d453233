#pragma once

#include "base/timeline.h"

#include <optional>

namespace vp
{

// While it lives, this thread works on a frame. Sections of the thread that lie in no other section get the number of
// the frame, and stops of the frame become points of a flow, if the timeline traces. A frame may go from thread to
// thread: each has a scope of its own, with the same number.
class FrameScope
{
public:
	// A frame is cut, drawn, and perhaps written.
	enum class Stop
	{
		cut,
		picture,
		file
	};

	// last: where the flow of the frame ends. A frame that is only cut has no flow.
	FrameScope(int frame, Stop last);
	~FrameScope();
	FrameScope(const FrameScope&) = delete;
	FrameScope& operator=(const FrameScope&) = delete;

	// Returns Timeline::kNoFrame if this thread has no scope.
	static int frame();
	// The frame of this thread has come to a stop. Call it in the section that does the work. timeline: or null.
	static void comesTo(Stop stop, Timeline* timeline);

private:
	struct Place
	{
		int frame;
		Stop last;
	};
	static std::optional<Place>& here();

	std::optional<Place> before_;
};

} // namespace vp
