#pragma once

#include <cmath>

namespace vp::render
{

// A range narrower than this part of its values counts as constant, since layers have single precision.
constexpr double kNarrowestRange = 1e-7;

// Returns e of value = m 10^e with 1 <= m < 10, for value > 0.
inline int decimalExponent(double value)
{
	return static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

// Returns m times 10^e, rounded once. Division by an exact power is better than multiplication by an inexact one.
inline double timesPowerOfTen(double m, int e)
{
	return e >= 0 ? m * std::pow(10.0, e) : m / std::pow(10.0, -e);
}

} // namespace vp::render
