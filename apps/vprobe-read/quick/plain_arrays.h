#pragma once

#include "vprobe-read/arrays/plain_array.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::reader::quick
{

// Returns the plain arrays of a .vtu file of one piece: appended as raw bytes, in the order of this machine. Returns
// nothing for files that the quick reader does not support.
std::optional<std::vector<arrays::PlainArray>> plainArrays(const std::string& file);

} // namespace vp::reader::quick
