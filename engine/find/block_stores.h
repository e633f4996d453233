#pragma once

#include "base/pool.h"
#include "find/cell_marks.h"
#include "find/span_store.h"
#include "find/visited.h"
#include "grid/block.h"

#include <cstddef>

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

} // namespace vp::find
