#pragma once

#include <string>

// A text file that was cut short inside its last number cannot be told from a whole one, unless a line end follows the
// number.
bool endsInsideALine(const std::string& file);

constexpr const char* kCutTextWarning = "ends without a line end; if it was cut short, its last value is wrong";
