#include "write/xml_text.h"

#include <utf8.h>

namespace vp::write
{

std::string xmlText(const std::string& name)
{
	const bool is_utf8 = utf8::is_valid(name.begin(), name.end());
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
			    static_cast<unsigned char>(c) < ' ' || (static_cast<unsigned char>(c) >= 0x80 && !is_utf8) ? '_' : c;
	}
	return escaped;
}

} // namespace vp::write
