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
	// U+FFFE and U+FFFF are characters of no XML document.
	for (const char* forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
		for (std::size_t at = 0; is_utf8 && (at = escaped.find(forbidden, at)) != std::string::npos;)
			escaped.replace(at, 3, 1, '_');
	return escaped;
}

} // namespace vp::write
