#include "render/annotate/valid_utf8.h"

#include <utf8.h>

namespace vp::render
{

std::string validUtf8(std::string_view text)
{
	std::string valid;
	for (;;)
	{
		const auto* bad = utf8::find_invalid(text.begin(), text.end());
		valid.append(text.begin(), bad);
		if (bad == text.end())
			return valid;
		// Byte by byte: utf8::replace_invalid() would put one mark in the place of several.
		valid += "\uFFFD";
		text.remove_prefix(static_cast<std::size_t>(bad - text.begin()) + 1);
	}
}

} // namespace vp::render
