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

/// Memory that cuts of a block borrow and give back, kept from cut to cut. Thread safe.
struct BlockStores
{
	explicit BlockStores(const grid::Block& block);

	VisitedPool visited;   // for generations
	Pool<SpanStore> rows;  // for spans, of curvilinear grids
	Pool<CellMarks> marks; // for cells, of unstructured grids

	std::size_t bytes() const; // call this only while nothing is borrowed
};

/// Cuts a plane sheet in a block by a strategy without generations, as the plan of the block says: rows, spans or
/// cells. Every block has its own seeds, so the search does not cross seams.
///
/// seeds: from seed::findSeeds(); rows need none.
BlockCut findInBlock(Strategy strategy, const grid::Block& block, const probe::Sheet& sheet,
                     std::span<const CellId> seeds, BlockStores& stores);

} // namespace vp::find
