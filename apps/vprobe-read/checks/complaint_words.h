#pragma once

#include <string>
#include <string_view>

namespace vp::reader::checks
{

// A library's complaint speaks of its own internals, in its own words. These functions say what it means for the file.

// Returns true if memory ran out. Then the file may be good.
bool tellsOfMemory(std::string_view complaint);

// Returns what is wrong, and where, as far as the complaint says it.
std::string inOurWords(std::string_view complaint);

} // namespace vp::reader::checks
