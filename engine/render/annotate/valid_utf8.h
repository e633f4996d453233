#pragma once

#include <string>
#include <string_view>

namespace vp::render
{

// Names in files may be in any encoding: a byte that is no part of a letter becomes U+FFFD. What is a letter follows
// the Unicode standard, table 3-7: neither longer than need be nor of half a pair.
std::string validUtf8(std::string_view text);

} // namespace vp::render
