#pragma once

#include <numbers>

namespace vp
{

// Radians in a degree.
constexpr double kDegree = std::numbers::pi / 180.0;

} // namespace vp
