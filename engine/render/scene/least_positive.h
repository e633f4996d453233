#pragma once

#include "grid/block.h"
#include "grid/field_choice.h"

namespace vp::render
{

// Returns the smallest finite shown value above 0 over all blocks, 0 if there is none.
double leastPositive(const grid::BlockSet& blocks, const grid::FieldChoice& choice);

} // namespace vp::render
