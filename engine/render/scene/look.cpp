#include "render/scene/look.h"

#include <fmt/format.h>

#include <charconv>

namespace vp::render
{

namespace
{

std::optional<Color> colorFromHex(std::string_view digits)
{
	unsigned value = 0;
	const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
	if (error != std::errc{} || end != digits.data() + digits.size())
		return std::nullopt;
	const auto byte = [value](int shift) { return static_cast<std::uint8_t>(value >> shift & 0xFFu); };
	const auto nibble = [value](int shift) { return static_cast<std::uint8_t>(17u * (value >> shift & 0xFu)); };
	if (digits.size() == 6)
		return Color{byte(16), byte(8), byte(0)};
	if (digits.size() == 3)
		return Color{nibble(8), nibble(4), nibble(0)};
	return std::nullopt;
}

Background plain(Color color)
{
	return {color, color};
}

} // namespace

bool Background::dark() const
{
	if (transparent())
		return false;
	const auto luma = [](Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
	return 0.5 * (luma(top) + luma(bottom)) < 110.0;
}

std::optional<Color> parseColor(std::string_view text)
{
	if (text == "white")
		return Color{255, 255, 255};
	if (text == "black")
		return Color{0, 0, 0};
	if (text == "grey" || text == "gray")
		return Color{128, 128, 128};
	return text.starts_with('#') ? colorFromHex(text.substr(1)) : std::nullopt;
}

Result<Background> parseBackground(std::string_view text)
{
	if (text == "gradient")
		return Background{};
	if (text == "transparent")
		return plain({0, 0, 0, 0});
	if (const auto color = parseColor(text))
		return plain(*color);
	return Error{ErrorKind::usage, "no color; take gradient, white, grey, black, transparent, or #RRGGBB"};
}

std::string backgroundText(const Background& background)
{
	for (const char* name : {"gradient", "transparent", "white", "black", "grey"})
		if (*parseBackground(name) == background)
			return name;
	const Color color = background.top;
	return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

Result<std::pair<std::uint32_t, std::uint32_t>> parseSize(std::string_view text)
{
	std::uint32_t width = 0;
	std::uint32_t height = 0;
	const char* const end = text.data() + text.size();
	const auto [x, first_error] = std::from_chars(text.data(), end, width);
	if (first_error == std::errc{} && x != end && *x == 'x')
	{
		const auto [last, second_error] = std::from_chars(x + 1, end, height);
		if (second_error == std::errc{} && last == end && width > 0 && height > 0 && width <= kMaxPictureSize &&
		    height <= kMaxPictureSize)
			return std::pair{width, height};
	}
	return Error{ErrorKind::usage,
	             fmt::format("no size; write WIDTHxHEIGHT in pixels, as 1280x720, up to {}", kMaxPictureSize)};
}

Result<double> parseTextSize(std::string_view text)
{
	constexpr double kPixelsPerPoint = 4.0 / 3.0;
	double size = 0.0;
	const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), size);
	const std::string_view unit(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
	if (unit == "pt")
		size *= kPixelsPerPoint;
	if (error == std::errc{} && (unit.empty() || unit == "px" || unit == "pt") && size >= kMinTextSize &&
	    size <= kMaxTextSize)
		return size;
	return Error{ErrorKind::usage,
	             fmt::format("no size of text; write pixels or points, as 14 or 9pt, from {} to {} pixels",
	                         kMinTextSize, kMaxTextSize)};
}

} // namespace vp::render
