#pragma once

#include "session/session.h"

#include <array>
#include <vector>

namespace vp::app
{

/// The frames by which the sweep of a state is judged, as `vprobe sweep` makes them.
class SweepFrames
{
public:
	/// Endings of the pictures of the first, the middle and the last frame.
	static constexpr std::array kEndings{".first.png", ".middle.png", ".last.png"};

	/// Takes the sweep of the session's settings.
	static Result<SweepFrames> of(const session::Session& session);

	/// If the sweep is over the times of the input, goes to that of a frame. which: 0, 1, 2 as in kEndings.
	Status goTo(session::Session& session, std::size_t which) const;
	session::FrameRequest request(std::size_t which) const;
	bool isOverTimes() const { return !times_.empty(); }

private:
	std::array<int, kEndings.size()> numbers_{};
	std::vector<session::FrameRequest> requests_; // one for each of kEndings
	std::vector<double> times_;                   // the input's, if the sweep is over them
};

} // namespace vp::app
