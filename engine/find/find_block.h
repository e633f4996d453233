#pragma once

#include "base/pool.h"
#include "find/block_cut.h"
#include "find/cell_marks.h"
#include "find/plan.h"
#include "find/span_store.h"
#include "find/visited.h"
#include "grid/block.h"
#include "probe/sheet.h"

#include <cstddef>
#include <span>

namespace vp::find
{

/// What the cuts of a block borrow and give back, kept from cut to cut. Thread safe.
struct BlockStores
{
	explicit BlockStores(const grid::Block& block);

	VisitedPool visited;   // for generations
	Pool<SpanStore> rows;  // for spans, of curvilinear grids
	Pool<CellMarks> marks; // for cells, of unstructured grids

	std::size_t bytes() const; // while nothing is borrowed
};

/// The cut of a plane sheet in a block by a strategy that needs no generations: rows, spans or cells, which the block's
/// plan has chosen. Every block is searched from seeds of its own, so that nothing has to be followed across seams.
///
/// seeds: as of seed::findSeeds(); rows need none.
BlockCut findInBlock(Strategy strategy, const grid::Block& block, const probe::Sheet& sheet,
                     std::span<const CellId> seeds, BlockStores& stores);

} // namespace vp::find
