#pragma once

#include "surface/expression_tree.h"

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace vp::surface
{

// By repeated squaring.
inline double integerPower(double a, int exponent)
{
	double power = 1.0;
	double base = a;
	for (int left = std::abs(exponent); left > 0; left >>= 1)
	{
		if (left & 1)
			power *= base;
		base *= base;
	}
	return exponent < 0 ? 1.0 / power : power;
}

// Calls visit(f), f(a, b) being the operation in double; operations of one operand ignore b. Folding, single points and
// batches all compute by these, so that they agree in every bit. NaN comes out wherever it goes in, of min and max too.
template <class Visit>
decltype(auto) withOperation(Operation operation, int exponent, Visit&& visit)
{
	switch (operation)
	{
	case Operation::add:
		return visit([](double a, double b) { return a + b; });
	case Operation::subtract:
		return visit([](double a, double b) { return a - b; });
	case Operation::multiply:
		return visit([](double a, double b) { return a * b; });
	case Operation::divide:
		return visit([](double a, double b) { return a / b; });
	case Operation::negate:
		return visit([](double a, double) { return -a; });
	case Operation::square:
		return visit([](double a, double) { return a * a; });
	case Operation::integer_power:
		return visit([exponent](double a, double) { return integerPower(a, exponent); });
	case Operation::pow:
		return visit([](double a, double b) { return std::pow(a, b); });
	case Operation::abs:
		return visit([](double a, double) { return std::abs(a); });
	case Operation::sqrt:
		return visit([](double a, double) { return std::sqrt(a); });
	case Operation::cbrt:
		return visit([](double a, double) { return std::cbrt(a); });
	case Operation::exp:
		return visit([](double a, double) { return std::exp(a); });
	case Operation::log:
		return visit([](double a, double) { return std::log(a); });
	case Operation::log2:
		return visit([](double a, double) { return std::log2(a); });
	case Operation::log10:
		return visit([](double a, double) { return std::log10(a); });
	case Operation::sin:
		return visit([](double a, double) { return std::sin(a); });
	case Operation::cos:
		return visit([](double a, double) { return std::cos(a); });
	case Operation::tan:
		return visit([](double a, double) { return std::tan(a); });
	case Operation::asin:
		return visit([](double a, double) { return std::asin(a); });
	case Operation::acos:
		return visit([](double a, double) { return std::acos(a); });
	case Operation::atan:
		return visit([](double a, double) { return std::atan(a); });
	case Operation::sinh:
		return visit([](double a, double) { return std::sinh(a); });
	case Operation::cosh:
		return visit([](double a, double) { return std::cosh(a); });
	case Operation::tanh:
		return visit([](double a, double) { return std::tanh(a); });
	case Operation::atan2:
		return visit([](double a, double b) { return std::atan2(a, b); });
	case Operation::hypot:
		return visit([](double a, double b) { return std::hypot(a, b); });
	case Operation::min:
		return visit([](double a, double b) { return a < b || a != a ? a : b; });
	case Operation::max:
		return visit([](double a, double b) { return a > b || a != a ? a : b; });
	case Operation::x:
	case Operation::y:
	case Operation::z:
	case Operation::number:
		break;
	}
	assert(false);
	return visit([](double a, double) { return a; });
}

} // namespace vp::surface
