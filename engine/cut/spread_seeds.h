#pragma once

#include "cut/cut.h"
#include "grid/block.h"

#include <cstddef>

namespace vp::cut
{

/// Adds seeds of a plane sheet in a block, so that there are few generations. If the sheet has hardly moved, these are
/// the cells of its cut before, else cells along a lattice of hot spots. was: the cut before, or null. Do not use this
/// with a threshold. Cells that the threshold rejects may enclose others, which must not be found.
void spreadSeeds(const grid::Block& block, std::size_t number, const SheetCut* was, SheetCut& sheet);

} // namespace vp::cut
