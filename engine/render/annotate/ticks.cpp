#include "render/annotate/ticks.h"

#include "render/scene/levels.h"
#include "render/scene/round_numbers.h"

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

Ticks constantTick(double value, int digits = 4)
{
	Ticks ticks;
	ticks.marks.push_back({value, shortNumber(value, digits)});
	return ticks;
}

// Returns the least distance between ascending values. For a single value, returns a millionth of it.
double leastDistance(const std::vector<double>& values)
{
	double least = std::numeric_limits<double>::infinity();
	for (std::size_t i = 1; i < values.size(); ++i)
		least = std::min(least, values[i] - values[i - 1]);
	return values.size() == 1 ? 1e-6 * std::abs(values.front()) : least;
}

// Digits after the point that tell the multiples of 10^-factor apart from rounded ones, by a thousandth of `step`.
int decimalsOf(const std::vector<double>& values, int factor, double step)
{
	const auto fits = [&](int decimals)
	{
		return std::all_of(values.begin(), values.end(),
		                   [&](double v)
		                   {
			                   const double digits = timesPowerOfTen(v, decimals - factor);
			                   return std::abs(std::round(digits) - digits) <=
			                          1e-3 * timesPowerOfTen(step, decimals - factor);
		                   });
	};
	int decimals = 0;
	while (decimals < 12 && !fits(decimals))
		++decimals;
	return decimals;
}

void setFactor(Ticks& ticks, int exponent)
{
	ticks.exponent = exponent;
	if (exponent != 0)
		ticks.factor = "×10" + superscript(exponent);
}

Ticks linearTicks(const std::vector<double>& values)
{
	Ticks ticks;
	if (values.size() == 1)
		return constantTick(values.front(), digitsApart(values));
	const double largest = std::max(std::abs(values.front()), std::abs(values.back()));
	const double step = leastDistance(values);
	const int factor = isPlain(largest) && step >= 1e-6 ? 0 : decimalExponent(largest);
	setFactor(ticks, factor);
	const int decimals = decimalsOf(values, factor, step);
	for (const double value : values)
		ticks.marks.push_back({value, withMinus(fmt::format("{:.{}f}", timesPowerOfTen(value, -factor), decimals))});
	return ticks;
}

std::string logLabel(double value, bool plain)
{
	const int exponent = decimalExponent(value);
	const double digits = timesPowerOfTen(value, -exponent);
	if (plain)
		return shortNumber(value);
	return (std::abs(digits - 1.0) < 1e-6 ? "" : fmt::format("{:.3g}×", digits)) + "10" + superscript(exponent);
}

// Returns the label of an end of a linear scale, rounded to a thousandth of it, without zeros at its end.
std::string endLabel(double value, double lo, double hi, int exponent)
{
	if (exponent == 0 && !isPlain(std::max(std::abs(lo), std::abs(hi))))
		return shortNumber(value);
	constexpr int kDigits = 3; // a thousandth
	const int of_range = decimalExponent(2.0 * (0.5 * hi - 0.5 * lo)) - exponent;
	const int decimals = std::clamp(kDigits - of_range, 0, 15);
	std::string digits = fmt::format("{:.{}f}", timesPowerOfTen(value, -exponent), decimals);
	if (decimals > 0)
	{
		digits.erase(digits.find_last_not_of('0') + 1);
		if (digits.ends_with('.'))
			digits.pop_back();
	}
	return digits == "-0" ? "0" : withMinus(digits);
}

bool isNarrow(double lo, double hi, double narrowest)
{
	const double largest = std::max(std::abs(lo), std::abs(hi));
	// Halves, for the difference of huge values may overflow.
	const double half = 0.5 * hi - 0.5 * lo;
	return !(half > 0.5 * narrowest * largest) || largest < 1e12 * std::numeric_limits<double>::min();
}

// Powers of ten as such where plain digits would be long.
Ticks logTicks(const std::vector<double>& values)
{
	Ticks ticks;
	const bool plain = isPlain(values.front()) && isPlain(values.back());
	for (const double value : values)
		ticks.marks.push_back({value, logLabel(value, plain)});
	return ticks;
}

// Which of the first `stride` values to begin with, so that every stride-th is as round as can be: 0 and multiples of
// their distance are among them, or powers of ten.
std::size_t roundestStart(const std::vector<double>& values, std::size_t stride, bool logarithmic)
{
	std::size_t best = 0;
	double least = std::numeric_limits<double>::infinity();
	for (std::size_t start = 0; stride > 1 && start < stride && start < values.size(); ++start)
	{
		double off = 0.0;
		if (logarithmic)
			for (std::size_t i = start; i < values.size(); i += stride)
				off -= std::abs(timesPowerOfTen(values[i], -decimalExponent(values[i])) - 1.0) < 1e-6;
		else
			off = std::abs(std::remainder(values[start], static_cast<double>(stride) * (values[1] - values[0])));
		if (off < least)
		{
			least = off;
			best = start;
		}
	}
	return best;
}

} // namespace

Ticks ticksAt(const std::vector<double>& values, int most, bool logarithmic)
{
	if (values.empty())
		return {};
	const std::size_t stride = (values.size() + static_cast<std::size_t>(most) - 1) / static_cast<std::size_t>(most);
	std::vector<double> kept;
	for (std::size_t i = roundestStart(values, stride, logarithmic); i < values.size(); i += stride)
		kept.push_back(values[i]);
	return logarithmic ? logTicks(kept) : linearTicks(kept);
}

Ticks makeLogTicks(double lo, double hi, int most)
{
	if (!(hi > lo))
		return constantTick(lo);
	// The ends count too.
	std::vector<double> values;
	for (int about = most; about > 0 && (values.empty() || static_cast<int>(values.size()) > most); --about)
		values = roundLevels(lo * (1.0 - 1e-5), hi * (1.0 + 1e-5), about, true);
	for (double& value : values)
		value = std::clamp(value, lo, hi);
	return values.empty() ? ticksAt({lo, hi}, most, true) : ticksAt(values, most, true);
}

Ticks makeTicks(double lo, double hi, int most, double narrowest)
{
	if (lo > hi)
		std::swap(lo, hi);
	const double largest = std::max(std::abs(lo), std::abs(hi));
	const double half = 0.5 * hi - 0.5 * lo;
	if (isNarrow(lo, hi, narrowest))
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
	setFactor(ticks, factor);
	for (double i = first; i <= last; i += 1.0)
	{
		const double multiple = i == 0.0 ? 0.0 : i * leading; // no negative zero
		const double value = std::clamp(timesPowerOfTen(multiple, exponent), lo, hi);
		ticks.marks.push_back(
		    {value, withMinus(fmt::format("{:.{}f}", timesPowerOfTen(multiple, exponent - factor), decimals))});
	}
	return ticks;
}

void addEnds(Ticks& ticks, double lo, double hi, double apart, bool logarithmic)
{
	if (!(hi > lo) || (!logarithmic && isNarrow(lo, hi, kNarrowestRange)))
		return;
	const auto scaled = [&](double value) { return logarithmic ? std::log10(value) : value; };
	const double length = scaled(hi) - scaled(lo);
	for (const double end : {lo, hi})
	{
		const auto share = [&](const Tick& mark) { return std::abs(scaled(mark.value) - scaled(end)) / length; };
		constexpr double kSame = 1e-6; // part of the scale that no picture shows
		if (std::ranges::any_of(ticks.marks, [&](const Tick& mark) { return share(mark) < kSame; }))
			continue;
		std::erase_if(ticks.marks, [&](const Tick& mark) { return share(mark) < apart; });
		ticks.marks.insert(
		    end == lo ? ticks.marks.begin() : ticks.marks.end(),
		    {end, logarithmic ? logLabel(end, isPlain(lo) && isPlain(hi)) : endLabel(end, lo, hi, ticks.exponent)});
	}
}

int digitsApart(const std::vector<double>& values)
{
	const double slack = 1e-3 * leastDistance(values);
	const auto fits = [&](double value, int digits)
	{ return std::abs(std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr) - value) <= slack; };
	int digits = 4;
	while (digits < std::numeric_limits<double>::digits10 &&
	       !std::ranges::all_of(values, [&](double value) { return fits(value, digits); }))
		++digits;
	return digits;
}

std::string shortNumber(double value, int significant)
{
	if (value == 0.0)
		return "0";
	if (!std::isfinite(value))
		return withMinus(fmt::format("{}", value));
	const std::string digits = fmt::format("{:.{}g}", value, significant);
	const auto e = digits.find('e');
	if (e == std::string::npos)
		return withMinus(digits);
	return withMinus(digits.substr(0, e)) + "×10" + superscript(std::atoi(digits.c_str() + e + 1));
}

} // namespace vp::render
