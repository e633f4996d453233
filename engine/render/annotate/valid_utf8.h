#pragma once

#include <string>
#include <string_view>

namespace vp::render
{

// Returns a text in which each byte that is not part of a letter is U+FFFD, since names in files may have any encoding.
// Table 3-7 of the Unicode standard says what a letter is: overlong forms and halves of surrogate pairs are none.
std::string validUtf8(std::string_view text);

} // namespace vp::render
