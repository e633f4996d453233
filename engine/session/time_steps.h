#pragma once

#include "read/read.h"

#include <string>
#include <vector>

namespace vp::session
{

// A choice of one of ascending times: by its value, since inputs may have different ones, or by its index where others
// are equal to it.
read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index);

class Session;

/// Returns the time of a session's values with its units, such as "t = 0.25 s", in as many digits as tell it from the
/// other times of the inputs; empty if they have no times.
std::string timeText(const Session& session);

} // namespace vp::session
