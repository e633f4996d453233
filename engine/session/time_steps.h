#pragma once

#include "session/painter.h"
#include "session/session.h"

#include <optional>
#include <vector>

namespace vp::session
{

// Takes a session to a time of its inputs. True: the grid is the same, and a cut of it needs other values only. False:
// it was read and built anew. painter: told of what changes; null where nothing is drawn.
Result<bool> moveToTime(Session& session, const read::TimeChoice& time, Painter* painter);

// Takes a session from one of its inputs' times to another. Where only values differ the cut is kept and gathers them;
// where the grid moves it is read and cut anew. All it is made of outlives it.
class TimeSteps
{
public:
	// painter: told of what changes; null where nothing is drawn.
	TimeSteps(Session& session, Painter* painter);

	int count() const { return static_cast<int>(times_.size()); }
	Result<cut::Cut> cutAt(int step);

private:
	Session& session_;
	Painter* painter_;
	std::vector<double> times_;
	std::optional<cut::Cut> kept_;
};

} // namespace vp::session
