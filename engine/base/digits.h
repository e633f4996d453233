#pragma once

#include <algorithm>
#include <cmath>

namespace vp
{

// Returns how many significant digits numbers of up to `largest` need, so that those which are `step` apart look
// different.
inline int digitsFor(double largest, double step, int least = 6, int most = 17)
{
	if (!(step > 0.0) || !std::isfinite(largest))
		return least;
	const double apart = std::floor(std::log10(std::abs(largest)) - std::log10(step)) + 2.0;
	return static_cast<int>(std::clamp(apart, static_cast<double>(least), static_cast<double>(most)));
}

// The same for the ends of a range, of which a ten-thousandth of the width is told. At most 15 digits, which decimal
// numbers keep in double precision, unless the ends would look the same.
inline int digitsForRange(double lo, double hi, int most = 15)
{
	if (!(lo < hi))
		return 7; // those of single precision
	const double largest = std::max(std::abs(lo), std::abs(hi));
	return std::max(digitsFor(largest, 1e-4 * (hi - lo), 6, most), digitsFor(largest, hi - lo));
}

} // namespace vp
