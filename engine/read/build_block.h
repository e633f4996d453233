#pragma once

#include "grid/block.h"
#include "read/manifest.h"

#include <string>

namespace vp::read
{

// A checked block with its grid, finished (see finishBlock) but for its seams with others. Cells of an unstructured one
// are listed. `identifies_geometry`: and `for_one_cut`: see ReadOptions.
grid::Block buildBlock(CheckedBlock&& checked, std::string name, bool identifies_geometry = true,
                       bool for_one_cut = false);

} // namespace vp::read
