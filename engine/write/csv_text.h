#pragma once

#include "grid/field.h"

#include <cstddef>
#include <string>

namespace vp::write
{

// A field of a CSV file, RFC 4180: one with a comma, a quote or a line end stands in quotes, its quotes doubled.
inline std::string quoted(const std::string& text)
{
	if (text.find_first_of(",\"\r\n") == std::string::npos)
		return text;
	std::string result = "\"";
	for (const char c : text)
	{
		if (c == '"')
			result += '"';
		result += c;
	}
	return result + '"';
}

// A comma and a number for each component, in the fewest digits that give the same number back.
void appendNumbers(std::string& row, grid::NumberType type, const std::byte* at, int components);

} // namespace vp::write
