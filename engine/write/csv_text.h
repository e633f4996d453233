#pragma once

#include "grid/field.h"

#include <cstddef>
#include <string>

namespace vp::write
{

// Returns a field of a CSV file (RFC 4180). A field with a comma, a quote or a line end is put in quotes, and its
// quotes are doubled.
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

// Appends a comma and a number for each component, with the fewest digits that are read as the same number.
void appendNumbers(std::string& row, grid::NumberType type, const std::byte* at, int components);

} // namespace vp::write
