#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vp
{

/// Letters that a terminal takes for commands, or that turn the order of others: those of ASCII, U+0080 to U+009F,
/// U+061C, U+200E, U+200F, U+202A to U+202E and U+2066 to U+2069, in UTF-8. Names in a file may hold any.

/// Returns the number of bytes of the control letter that a text begins with, or 0 if it begins with another letter.
std::size_t controlLetter(std::string_view text);

/// Returns a text with its control letters as escapes: "\x1b", "\u202e".
std::string withEscapes(std::string_view text);

} // namespace vp
