#pragma once

#include "painter.h"
#include "session.h"

#include <optional>
#include <vector>

namespace vp::app
{

// Takes a session from one of its inputs' times to another. Where only values differ the cut is kept and gathers them;
// where the grid moves it is read and cut anew. All it is made of outlives it.
class TimeSteps
{
public:
	// painter: told of what changes; null where nothing is drawn.
	TimeSteps(Session& session, const ProbeOptions& options, Painter* painter);

	int count() const { return static_cast<int>(times_.size()); }
	Result<slice::Slice> cutAt(int step);

private:
	Status buildAnew(const read::ReadOptions& at);

	Session& session_;
	const ProbeOptions& options_;
	Painter* painter_;
	std::vector<double> times_;
	std::optional<slice::Slice> kept_;
};

} // namespace vp::app
