#pragma once

#include "grid/imaging.h"
#include "ranks/message.h"

namespace vp::ranks
{

// Puts what a file says of pictures into a message, and takes it out again.
void putImaging(MessageWriter& to, const grid::Imaging& imaging);
grid::Imaging getImaging(MessageReader& from);

} // namespace vp::ranks
