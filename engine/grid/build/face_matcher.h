#pragma once

#include "grid/block.h"

#include <vector>

namespace vp::grid
{

// The boundary faces of all blocks that lie on each other, see matchInterfaces(): per block the links from its side, in
// no order.
std::vector<std::vector<SeamLink>> matchFaces(const BlockSet& blocks);

} // namespace vp::grid
