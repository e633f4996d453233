#pragma once

#include "door.h"
#include "vprobe-read/base/request.h"

namespace vp::reader::door
{

// Returns what a request needs: the input, or all of its folder where its format may name other files (FormatFiles),
// the folders that the user trusts, and the folders of libraries.
Opening openingFor(const Request& request);

// The program that vprobe-read may become. Empty in that program itself.
std::string programWithMore();

} // namespace vp::reader::door
