#include "surface/dual.h"

#include "surface/expression_operations.h"

#include <numbers>

namespace vp::surface
{

namespace
{

struct Slopes
{
	double by_a;
	double by_b = 0.0;
};

// Returns the slopes of a^b.
Slopes slopesOfPower(const Dual& a, const Dual& b, double power)
{
	const double by_a = b.value * std::pow(a.value, b.value - 1.0);
	// A constant exponent does not need the logarithm, whose argument may be negative.
	return {by_a, b.slope == Vec3(0.0) || power == 0.0 ? 0.0 : power * std::log(a.value)};
}

Slopes slopesOfTwo(Operation operation, const Dual& a, const Dual& b, double value)
{
	switch (operation)
	{
	case Operation::add:
		return {1.0, 1.0};
	case Operation::subtract:
		return {1.0, -1.0};
	case Operation::multiply:
		return {b.value, a.value};
	case Operation::divide:
		return {1.0 / b.value, -value / b.value};
	case Operation::pow:
		return slopesOfPower(a, b, value);
	case Operation::atan2:
	{
		const double squares = a.value * a.value + b.value * b.value;
		return {b.value / squares, -a.value / squares};
	}
	case Operation::hypot:
		return {a.value / value, b.value / value};
	default: // min, max
		return value == a.value ? Slopes{1.0, 0.0} : Slopes{0.0, 1.0};
	}
}

double slopeOfOne(Operation operation, int exponent, double a, double value)
{
	switch (operation)
	{
	case Operation::negate:
		return -1.0;
	case Operation::square:
		return 2.0 * a;
	case Operation::integer_power:
		return exponent * integerPower(a, exponent - 1);
	case Operation::abs:
		return a < 0.0 ? -1.0 : 1.0;
	case Operation::sqrt:
		return 0.5 / value;
	case Operation::cbrt:
		return 1.0 / (3.0 * value * value);
	case Operation::exp:
		return value;
	case Operation::log:
		return 1.0 / a;
	case Operation::log2:
		return std::numbers::log2e / a;
	case Operation::log10:
		return std::numbers::log10e / a;
	case Operation::sin:
		return std::cos(a);
	case Operation::cos:
		return -std::sin(a);
	case Operation::tan:
		return 1.0 + value * value;
	case Operation::asin:
		return 1.0 / std::sqrt(1.0 - a * a);
	case Operation::acos:
		return -1.0 / std::sqrt(1.0 - a * a);
	case Operation::atan:
		return 1.0 / (1.0 + a * a);
	case Operation::sinh:
		return std::cosh(a);
	case Operation::cosh:
		return std::sinh(a);
	default: // tanh
		return 1.0 - value * value;
	}
}

// A value that does not depend on a variable stays independent of it, even if the slope is not finite.
Vec3 scaled(double by, const Vec3& slope)
{
	return {slope.x == 0.0 ? 0.0 : by * slope.x, slope.y == 0.0 ? 0.0 : by * slope.y,
	        slope.z == 0.0 ? 0.0 : by * slope.z};
}

} // namespace

Dual applied(Operation operation, int exponent, const Dual& a, const Dual& b)
{
	const double value = withOperation(operation, exponent, [&](auto f) { return f(a.value, b.value); });
	if (!takesTwo(operation))
		return {value, scaled(slopeOfOne(operation, exponent, a.value, value), a.slope)};
	const Slopes slopes = slopesOfTwo(operation, a, b, value);
	return {value, scaled(slopes.by_a, a.slope) + scaled(slopes.by_b, b.slope)};
}

} // namespace vp::surface
