#pragma once

#include <string>
#include <vector>

namespace vp::app
{

/// Returns the arguments, those after the program's name, last first as CLI11 takes them. The numbers after an option
/// that takes one word or several numbers (--normal z or 0 0 1) are joined into one argument. For CLI11 such an option
/// takes one argument: if it took more, it would also take an INPUT that follows a word.
std::vector<std::string> joinNumbers(const std::vector<std::string>& given);

/// The arguments of this process, those after the program's name, for a command that starts itself again.
const std::vector<std::string>& commandLine();
void setCommandLine(std::vector<std::string> arguments);

} // namespace vp::app
