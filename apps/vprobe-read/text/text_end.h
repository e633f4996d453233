#pragma once

#include <string>

namespace vp::reader::text
{

// Returns true if no line end follows the last word of a text file. A file that was cut short inside its last number
// then looks like a whole one.
bool endsInsideALine(const std::string& file);

constexpr const char* kCutTextWarning = "ends without a line end; if it was cut short, its last value is wrong";

} // namespace vp::reader::text
