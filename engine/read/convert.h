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
// time, with the wanted arrays; one that is not there is a usage error. It is written into `folder`, which is the
// caller's own and empty, under the target's name; the pieces of a .vtm lie beside it there, and it names them in a
// folder of its stem. The caller gives them their places. What was read is checked as for a cut. A .vtkhdf of an image
// gets its large arrays (stays_above) layer by layer, from files that have them as they are or in chunks.
Status convert(const std::string& input, const ReadOptions& options, const std::string& target,
               const std::string& folder);

} // namespace vp::read
