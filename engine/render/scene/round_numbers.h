#pragma once

#include <cmath>

namespace vp::render
{

// Ranges narrower than this part of their values are constant: the layers hold single precision.
constexpr double kNarrowestRange = 1e-7;

// e of value = m 10^e, 1 <= m < 10; for value > 0.
inline int decimalExponent(double value)
{
	return static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

// m times 10^e, rounded once: dividing by an exact power is better than multiplying with an inexact one.
inline double timesPowerOfTen(double m, int e)
{
	return e >= 0 ? m * std::pow(10.0, e) : m / std::pow(10.0, -e);
}

} // namespace vp::render
