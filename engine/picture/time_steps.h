#pragma once

#include "picture/painter.h"
#include "session/session.h"

#include <optional>
#include <vector>

namespace vp::picture
{

// A choice of one of ascending times: by its value, since inputs may have different ones, or by its index where others
// are equal to it.
read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index);

// Moves a session to a time of its inputs. Returns true if the grid is the same, so that a cut only needs other values;
// false if the grid was read and built again. painter: gets the changes, or null.
Result<bool> moveToTime(session::Session& session, const read::TimeChoice& time, Painter* painter);

// Moves a session from one time of its inputs to another. If only values differ, the cut is kept and gathers the new
// values. If the grid moves, it is read and cut again. All arguments outlive this object.
class TimeSteps
{
public:
	// painter: gets the changes, or null.
	TimeSteps(session::Session& session, Painter* painter);

	int count() const { return static_cast<int>(times_.size()); }
	Result<cut::Cut> cutAt(int step);

private:
	session::Session& session_;
	Painter* painter_;
	std::vector<double> times_;
	std::optional<cut::Cut> kept_;
};

} // namespace vp::picture
