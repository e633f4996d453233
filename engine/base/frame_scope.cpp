#include "base/frame_scope.h"

#include <utility>

namespace vp
{

std::optional<FrameScope::Place>& FrameScope::here()
{
	thread_local std::optional<Place> place;
	return place;
}

FrameScope::FrameScope(int frame, Stop last) : before_(std::exchange(here(), Place{frame, last})) {}

FrameScope::~FrameScope()
{
	here() = before_;
}

int FrameScope::frame()
{
	return here() ? here()->frame : Timeline::kNoFrame;
}

void FrameScope::comesTo(Stop stop, Timeline* timeline)
{
	using Kind = Timeline::Mark::Kind;
	if (!timeline || !timeline->traces() || !here() || here()->last == Stop::cut)
		return;
	const Kind kind = stop == Stop::cut ? Kind::flow_begin : stop == here()->last ? Kind::flow_end : Kind::flow_step;
	timeline->addFlowPoint(kind, static_cast<std::uint64_t>(here()->frame));
}

} // namespace vp
