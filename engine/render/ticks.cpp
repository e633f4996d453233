#include "render/ticks.h"

#include "render/round_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vp::render
{

namespace
{

// Plain digits from 0.001 up to 99999; beyond, a power of ten.
constexpr int kLowestPlainExponent = -3;
constexpr int kHighestPlainExponent = 4;

std::string superscript(int number)
{
	static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
	std::string text = number < 0 ? "⁻" : "";
	for (const char c : std::to_string(std::abs(number)))
		text += digits[c - '0'];
	return text;
}

std::string withMinus(std::string digits)
{
	return digits.starts_with('-') ? "\u2212" + digits.substr(1) : digits;
}

bool isPlain(double largest)
{
	if (largest == 0.0)
		return true;
	const int exponent = decimalExponent(largest);
	return exponent >= kLowestPlainExponent && exponent <= kHighestPlainExponent;
}

Ticks constantTick(double value)
{
	Ticks ticks;
	ticks.marks.push_back({value, shortNumber(value)});
	return ticks;
}

} // namespace

Ticks makeTicks(double lo, double hi, int most)
{
	if (lo > hi)
		std::swap(lo, hi);
	const double largest = std::max(std::abs(lo), std::abs(hi));
	// Halves, for the difference of huge values may overflow.
	const double half = 0.5 * hi - 0.5 * lo;
	if (!(half > 0.5 * kNarrowestRange * largest) || largest < 1e12 * std::numeric_limits<double>::min())
		return constantTick(lo + half);

	int exponent = decimalExponent(2.0 * (half / most)) - 1;
	double first = 0.0;
	double last = 0.0;
	int leading = 1;
	for (bool found = false; !found; ++exponent)
	{
		for (const int m : {1, 2, 5})
		{
			const double step = timesPowerOfTen(m, exponent);
			first = std::ceil(lo / step - 1e-6);
			last = std::floor(hi / step + 1e-6);
			leading = m;
			found = last - first + 1.0 <= most;
			if (found)
				break;
		}
	}
	--exponent;

	// Digits after the point are those of the step; a common factor moves the point.
	const bool plain = isPlain(largest) && -exponent <= 6;
	const int factor = plain ? 0 : decimalExponent(largest);
	const int decimals = std::max(0, factor - exponent);
	Ticks ticks;
	if (factor != 0)
		ticks.factor = "×10" + superscript(factor);
	for (double i = first; i <= last; i += 1.0)
	{
		const double multiple = i == 0.0 ? 0.0 : i * leading; // no negative zero
		const double value = std::clamp(timesPowerOfTen(multiple, exponent), lo, hi);
		ticks.marks.push_back(
		    {value, withMinus(fmt::format("{:.{}f}", timesPowerOfTen(multiple, exponent - factor), decimals))});
	}
	return ticks;
}

std::string shortNumber(double value)
{
	if (value == 0.0)
		return "0";
	if (!std::isfinite(value))
		return withMinus(fmt::format("{}", value));
	const std::string digits = fmt::format("{:.4g}", value);
	const auto e = digits.find('e');
	if (e == std::string::npos)
		return withMinus(digits);
	return withMinus(digits.substr(0, e)) + "×10" + superscript(std::atoi(digits.c_str() + e + 1));
}

} // namespace vp::render
