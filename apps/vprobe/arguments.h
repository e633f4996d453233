#pragma once

#include <string>
#include <vector>

namespace vp::app
{

// The arguments after the program's name, last first as CLI11 takes them. An option that takes one word or several
// numbers
// (--normal z or 0 0 1, --camera iso or nine numbers) has its values folded into one argument, so that an INPUT after
// it is not taken for one of them, and -x after --camera is not taken for an option.
std::vector<std::string> foldNumbers(int argc, const char* const* argv);

} // namespace vp::app
