#pragma once

#include "grid/block.h"
#include "read/manifest.h"

#include <string>

namespace vp::read
{

// Builds the grid of a checked block and finishes it (see finishBlock), without its seams to other blocks. Cells of an
// unstructured block are listed. `identifies_geometry`, `for_one_cut`: see ReadOptions. tolerance: of curved cells.
grid::Block buildBlock(CheckedBlock&& checked, std::string name, bool identifies_geometry = true,
                       bool for_one_cut = false, double tolerance = 0.0);

} // namespace vp::read
