#pragma once

#include "base/result.h"

#include <string>
#include <vector>

namespace vp::app
{

/// Returns the arguments with a command in front, if the first of them is an input and no command: `view` where there
/// is a display, otherwise `render` into a .png in the current folder, which must not exist yet. Returns a usage error
/// if the first argument is neither; it names the command that is spelled most alike.
///
/// arguments: those after the program's name. commands: the names of all commands. opens_files: whether the program has
/// `view` and `render` for inputs without a command.
Result<std::vector<std::string>> withCommand(std::vector<std::string> arguments,
                                             const std::vector<std::string>& commands, bool opens_files);

/// Returns the word of a list that is spelled most alike, or an empty one if none is nearly so.
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

} // namespace vp::app
