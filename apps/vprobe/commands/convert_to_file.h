#pragma once

#include "base/result.h"
#include "read/read.h"

#include <string>

namespace vp::app
{

// Has the reading process write one file, beside the output, which takes its place when it is whole.
Status convertToFile(const std::string& input, const read::ReadOptions& reading, const std::string& output);

} // namespace vp::app
