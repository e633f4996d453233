#pragma once

#include <string>

namespace vp::app
{

// A time as a person would write it, with three digits that count: "8.91 ms", "1.29 s", "2 min 5 s". milliseconds: 0 or
// more.
std::string durationText(double milliseconds);

} // namespace vp::app
