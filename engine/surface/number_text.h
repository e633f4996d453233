#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace vp::surface
{

// Returns the finite number that the whole text is, independent of the locale.
inline std::optional<double> numberOf(std::string_view text)
{
	double number = 0.0;
	const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
	if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
		return std::nullopt;
	return number;
}

} // namespace vp::surface
