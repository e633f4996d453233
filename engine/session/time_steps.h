#pragma once

#include "read/read.h"

#include <vector>

namespace vp::session
{

// A choice of one of ascending times: by its value, since inputs may have different ones, or by its index where others
// are equal to it.
read::TimeChoice choiceOfStep(const std::vector<double>& times, std::size_t index);

} // namespace vp::session
