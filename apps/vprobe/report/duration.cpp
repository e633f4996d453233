#include "report/duration.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::app
{

namespace
{

// Three digits that count, and never 1000.
std::string threeDigits(double number, const char* unit)
{
	return fmt::format("{:.{}f} {}", number, number < 9.995 ? 2 : number < 99.95 ? 1 : 0, unit);
}

} // namespace

std::string durationText(double milliseconds)
{
	if (milliseconds == 0.0)
		return "0 s";
	if (milliseconds < 0.9995)
		return threeDigits(1e3 * milliseconds, "µs");
	if (milliseconds < 999.5)
		return threeDigits(milliseconds, "ms");
	const double seconds = 1e-3 * milliseconds;
	if (seconds < 59.95)
		return threeDigits(seconds, "s");
	const double whole = std::round(seconds);
	return fmt::format("{:.0f} min {:.0f} s", std::floor(whole / 60.0), std::fmod(whole, 60.0));
}

} // namespace vp::app
