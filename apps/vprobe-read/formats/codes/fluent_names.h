#pragma once

#include <cstdint>
#include <string>

namespace vp::reader::codes
{

// Fluent's own name of values with this number in data files (its xfile.h), or "field NUMBER" for one that is not
// known.
std::string fluentName(std::int64_t number);

} // namespace vp::reader::codes
