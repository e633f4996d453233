#pragma once

#include "base/messages.h"

#include <string>
#include <string_view>

namespace vp::app
{

// A message of the engine names settings by their keys, as in "`color_by` array"; here they get the names of the
// options: "--color-by array".
std::string withOptionNames(std::string_view message);

// The name that stands before lines; "vprobe" where nothing else is set.
void setProgramName(std::string name);

// A line on standard error, "vprobe: LINE", with the names of options. Standard output belongs to results. Any thread.
void printLine(std::string_view line);

} // namespace vp::app
