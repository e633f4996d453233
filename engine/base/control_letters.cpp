#include "base/control_letters.h"

#include <fmt/format.h>

#include <iterator>

namespace vp
{

namespace
{

// Returns the letter of two or three bytes that a text begins with, or 0.
unsigned longLetter(std::string_view text, std::size_t bytes)
{
	if (text.size() < bytes)
		return 0;
	const auto part = [&](std::size_t i) { return static_cast<unsigned char>(text[i]) & 0x3Fu; };
	const auto isRest = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u; };
	const auto first = static_cast<unsigned char>(text[0]);
	if (bytes == 2)
		return (first & 0xE0u) == 0xC0u && isRest(1) ? (first & 0x1Fu) << 6 | part(1) : 0;
	return (first & 0xF0u) == 0xE0u && isRest(1) && isRest(2) ? (first & 0x0Fu) << 12 | part(1) << 6 | part(2) : 0;
}

bool isControl(unsigned letter)
{
	return (letter >= 0x80 && letter <= 0x9F) || letter == 0x061C || letter == 0x200E || letter == 0x200F ||
	       (letter >= 0x202A && letter <= 0x202E) || (letter >= 0x2066 && letter <= 0x2069);
}

} // namespace

std::size_t controlLetter(std::string_view text)
{
	if (text.empty())
		return 0;
	const auto first = static_cast<unsigned char>(text[0]);
	if (first < 0x20 || first == 0x7F)
		return 1;
	for (const std::size_t bytes : {std::size_t(2), std::size_t(3)})
		if (isControl(longLetter(text, bytes)))
			return bytes;
	return 0;
}

std::string withEscapes(std::string_view text)
{
	std::string safe;
	while (!text.empty())
	{
		const std::size_t bytes = controlLetter(text);
		if (bytes == 0)
			safe += text[0];
		else if (bytes == 1)
			fmt::format_to(std::back_inserter(safe), "\\x{:02x}", static_cast<unsigned char>(text[0]));
		else
			fmt::format_to(std::back_inserter(safe), "\\u{:04x}", longLetter(text, bytes));
		text.remove_prefix(bytes == 0 ? 1 : bytes);
	}
	return safe;
}

} // namespace vp
