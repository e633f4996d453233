#pragma once

#include <string>
#include <vector>

namespace vp::app
{

/// The arguments after the program's name, last first as CLI11 takes them. The numbers after an option that takes one
/// word or several numbers (--normal z or 0 0 1) are joined into one argument. For CLI11 such an option takes one
/// argument: with more, it would take an INPUT after a word for one of them.
std::vector<std::string> joinNumbers(int argc, const char* const* argv);

} // namespace vp::app
