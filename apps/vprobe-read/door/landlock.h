#pragma once

#include "door.h"

namespace vp::reader::door
{

// Which files this process may still open, by Linux's Landlock (since Linux 5.13). Returns the version that holds, or
// 0. It holds for all that this process becomes or starts.
int holdByLandlock(const Opening& opening);

} // namespace vp::reader::door
