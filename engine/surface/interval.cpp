#include "surface/interval.h"

#include "surface/expression_operations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::surface
{

namespace
{

constexpr double kPi = std::numbers::pi;
constexpr double kRounded = 0x1p-51;
constexpr double kLibrary = 0x1p-47;

const Interval kWholeLine{};

// Moved outwards by `slack` of their size; the whole line where an end is not finite. 0 stays, so that the root of what
// cannot be negative is defined.
Interval outward(double lo, double hi, double slack)
{
	const Interval moved{lo - std::abs(lo) * slack, hi + std::abs(hi) * slack};
	return std::isfinite(moved.lo) && std::isfinite(moved.hi) ? moved : kWholeLine;
}

// A function f(a, b) that for each a is monotone in b, and for each b in a: its extremes lie at corners.
template <class Function>
Interval ofCorners(const Interval& a, const Interval& b, double slack, Function f)
{
	const auto [lo, hi] = std::minmax({f(a.lo, b.lo), f(a.lo, b.hi), f(a.hi, b.lo), f(a.hi, b.hi)});
	return outward(lo, hi, slack);
}

template <class Function>
Interval ofMonotone(const Interval& a, double slack, Function f)
{
	const auto [lo, hi] = std::minmax({f(a.lo), f(a.hi)});
	return outward(lo, hi, slack);
}

Interval clampedTo(const Interval& bounds, const Interval& a)
{
	return {std::clamp(a.lo, bounds.lo, bounds.hi), std::clamp(a.hi, bounds.lo, bounds.hi)};
}

// From here on multiples of pi are not told apart with the slack below.
constexpr double kLargestAngle = 1e6;

// Returns true if `first` + k `period` lies within the interval for a whole number k, or so near that rounding leaves
// it open.
bool meetsMultiple(const Interval& a, double first, double period)
{
	const double slack = 1e-9;
	return std::floor((a.hi - first) / period + slack) >= std::ceil((a.lo - first) / period - slack);
}

Interval sineOf(const Interval& a, double (*function)(double), double crest)
{
	if (a.magnitude() > kLargestAngle)
		return {-1.0, 1.0};
	Interval wave = ofMonotone(a, kLibrary, function);
	if (meetsMultiple(a, crest, 2.0 * kPi))
		wave.hi = 1.0;
	if (meetsMultiple(a, crest + kPi, 2.0 * kPi))
		wave.lo = -1.0;
	return clampedTo({-1.0, 1.0}, wave);
}

Interval tangentOf(const Interval& a)
{
	if (a.magnitude() > kLargestAngle || meetsMultiple(a, 0.5 * kPi, kPi))
		return kWholeLine;
	return ofMonotone(a, kLibrary, [](double t) { return std::tan(t); });
}

Interval absoluteOf(const Interval& a)
{
	return {a.least(), a.magnitude()};
}

Interval integerPowerOf(const Interval& a, int exponent)
{
	if (exponent < 0 && a.contains(0.0))
		return kWholeLine;
	const double slack = kRounded * (1 + std::abs(exponent));
	const auto power = [&](double t) { return integerPower(t, exponent); };
	return ofMonotone(exponent % 2 ? a : absoluteOf(a), slack, power);
}

Interval powerOf(const Interval& a, const Interval& b)
{
	// Negative numbers have only integer powers, and an interval is not one integer. 0 has no negative powers.
	if (a.lo < 0.0 || (a.lo == 0.0 && b.lo <= 0.0))
		return kWholeLine;
	return ofCorners(a, b, kLibrary, [](double t, double s) { return std::pow(t, s); });
}

Interval angleOf(const Interval& y, const Interval& x)
{
	if (y.contains(0.0) && x.lo <= 0.0)
		return outward(-kPi, kPi, kLibrary);
	return ofCorners(y, x, kLibrary, [](double s, double t) { return std::atan2(s, t); });
}

Interval ofOne(Operation operation, int exponent, const Interval& a)
{
	const auto monotone = [&](double slack)
	{
		return withOperation(operation, exponent,
		                     [&](auto f) { return ofMonotone(a, slack, [&](double t) { return f(t, t); }); });
	};
	switch (operation)
	{
	case Operation::negate:
		return {-a.hi, -a.lo};
	case Operation::abs:
		return absoluteOf(a);
	case Operation::square:
		return integerPowerOf(a, 2);
	case Operation::integer_power:
		return integerPowerOf(a, exponent);
	case Operation::sqrt:
		return a.lo < 0.0 ? kWholeLine : monotone(kRounded);
	case Operation::log:
	case Operation::log2:
	case Operation::log10:
		return a.lo <= 0.0 ? kWholeLine : monotone(kLibrary);
	case Operation::asin:
	case Operation::acos:
		return a.lo < -1.0 || a.hi > 1.0 ? kWholeLine : monotone(kLibrary);
	case Operation::sin:
		return sineOf(a, std::sin, 0.5 * kPi);
	case Operation::cos:
		return sineOf(a, std::cos, 0.0);
	case Operation::tan:
		return tangentOf(a);
	case Operation::cosh:
		return ofMonotone(absoluteOf(a), kLibrary, [](double t) { return std::cosh(t); });
	default: // cbrt, exp, atan, sinh, tanh
		return monotone(kLibrary);
	}
}

} // namespace

Interval applied(Operation operation, int exponent, const Interval& a, const Interval& b)
{
	if (!a.isBounded() || !b.isBounded())
		return kWholeLine;
	const auto corners = [&]
	{ return withOperation(operation, exponent, [&](auto f) { return ofCorners(a, b, kRounded, f); }); };
	switch (operation)
	{
	case Operation::add:
	case Operation::subtract:
	case Operation::multiply:
		return corners();
	case Operation::divide:
		return b.contains(0.0) ? kWholeLine : corners();
	case Operation::min:
		return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
	case Operation::max:
		return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
	case Operation::pow:
		return powerOf(a, b);
	case Operation::atan2:
		return angleOf(a, b);
	case Operation::hypot:
		return ofCorners(absoluteOf(a), absoluteOf(b), kLibrary, [](double s, double t) { return std::hypot(s, t); });
	default:
		return ofOne(operation, exponent, a);
	}
}

} // namespace vp::surface
