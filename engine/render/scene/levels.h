#pragma once

#include <vector>

namespace vp::render
{

constexpr int kMaxLevels = 1000;

// About `about` round values strictly between lo < hi, ascending: multiples of 1, 2, 2.5 or 5 times a power of ten. On
// a logarithmic scale (0 < lo): powers of ten, of every so many decades, or these and 3, or 2 and 5, or all of 1 to 9,
// times them; within a decade multiples serve if they come closer. At least one if the range holds a round value at
// all; none where lo and hi agree to single precision.
std::vector<double> roundLevels(double lo, double hi, int about, bool logarithmic);

} // namespace vp::render
