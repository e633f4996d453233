#pragma once

#include "grid/block.h"
#include "slice/field_choice.h"

namespace vp::render
{

// The smallest finite shown value above 0 over all blocks. 0 where there is none.
double leastPositive(const grid::BlockSet& blocks, const slice::FieldChoice& choice);

} // namespace vp::render
