#pragma once

#include "cut/cut.h"
#include "grid/block.h"

#include <cstddef>

namespace vp::cut
{

/// More of generation 0 of a plane sheet in a block, so that the generations become few: the cells of the cut before
/// where the sheet has hardly moved, else those along a lattice of hot spots. was: the sheet's cut before, or null.
/// Not with a threshold: cells that it turns down may enclose others, which are not to be found.
void spreadSeeds(const grid::Block& block, std::size_t number, const SheetCut* was, SheetCut& sheet);

} // namespace vp::cut
