#include "write/xml_text.h"

#include <string_view>

namespace vp::write
{

namespace
{

bool isUtf8(std::string_view text)
{
	int following = 0;
	for (const unsigned char c : text)
	{
		if ((c & 0xC0) == 0x80)
		{
			if (following-- == 0)
				return false;
			continue;
		}
		if (following > 0)
			return false;
		following = c < 0x80 ? 0 : (c & 0xE0) == 0xC0 ? 1 : (c & 0xF0) == 0xE0 ? 2 : (c & 0xF8) == 0xF0 ? 3 : -1;
		if (following < 0)
			return false;
	}
	return following == 0;
}

} // namespace

std::string xmlText(const std::string& name)
{
	const bool utf8 = isUtf8(name);
	std::string escaped;
	for (const char c : name)
	{
		if (c == '&')
			escaped += "&amp;";
		else if (c == '<')
			escaped += "&lt;";
		else if (c == '"')
			escaped += "&quot;";
		else
			escaped +=
			    static_cast<unsigned char>(c) < ' ' || (static_cast<unsigned char>(c) >= 0x80 && !utf8) ? '_' : c;
	}
	return escaped;
}

} // namespace vp::write
