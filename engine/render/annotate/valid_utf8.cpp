#include "render/annotate/valid_utf8.h"

#include <algorithm>

namespace vp::render
{

namespace
{

// Bytes of the letter that the text begins with, 0 where it is none.
std::size_t letterAt(std::string_view text)
{
	const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
	const unsigned first = byte(0);
	if (first < 0x80)
		return 1;
	const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
	                           : first >= 0xE0 && first <= 0xEF ? 3
	                           : first >= 0xF0 && first <= 0xF4 ? 4
	                                                            : 0;
	for (std::size_t i = 1; i < length; ++i)
		if ((byte(i) & 0xC0) != 0x80)
			return 0;
	const unsigned second = byte(1);
	const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
	const bool beyond = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
	return too_long || beyond ? 0 : length;
}

} // namespace

std::string validUtf8(std::string_view text)
{
	std::string valid;
	while (!text.empty())
	{
		const std::size_t length = letterAt(text);
		if (length > 0)
			valid += text.substr(0, length);
		else
			valid += "\uFFFD";
		text.remove_prefix(std::max<std::size_t>(length, 1));
	}
	return valid;
}

} // namespace vp::render
