#pragma once

#include <vector>

namespace vp::render
{

constexpr int kMaxLevels = 1000;

// Returns about `about` ascending round values strictly between lo < hi: multiples of 1, 2, 2.5 or 5 times a power of
// ten. On a logarithmic scale (0 < lo) they are powers of ten, every second, third … of them, or each power times 1 and
// 3, times 1, 2 and 5, or times 1 to 9. Within one decade, multiples are used if their number is closer to `about`.
// There is at least one value if the range contains a round value, and none if lo and hi agree in single precision.
std::vector<double> roundLevels(double lo, double hi, int about, bool logarithmic);

} // namespace vp::render
