#pragma once

#include "find/block_cut.h"
#include "find/block_stores.h"
#include "find/plan.h"
#include "grid/block.h"
#include "probe/sheet.h"

#include <span>

namespace vp::find
{

/// The cut of a plane sheet in a block by a strategy that needs no generations: rows, spans or cells, which the block's
/// plan has chosen. Every block is searched from seeds of its own, so that nothing has to be followed across seams.
///
/// seeds: as of seed::findSeeds(); rows need none.
BlockCut findInBlock(Strategy strategy, const grid::Block& block, const probe::Sheet& sheet,
                     std::span<const CellId> seeds, BlockStores& stores);

} // namespace vp::find
