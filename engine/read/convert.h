#pragma once

#include "base/result.h"
#include "read/read.h"

#include <string>

namespace vp::read
{

// Endings that convert() writes, separated by spaces.
constexpr const char* kConvertEndings = ".vti .vtr .vts .vtu .vtm .vtkhdf";

bool canConvertTo(const std::string& target);

// Reads a file and has the reading process write it as the VTK format that the ending of `target` asks for, at one
// time, with the wanted arrays. The bytes go to `beside`, which the caller gives the name of the target; the pieces of
// a .vtm go to a folder of its name, which must not exist. What was read is checked as for a cut.
Status convert(const std::string& input, const ReadOptions& options, const std::string& target,
               const std::string& beside);

} // namespace vp::read
