#pragma once

#include "base/ids.h"
#include "find/span_cut.h"
#include "find/span_store.h"
#include "grid/structured.h"
#include "seed/sheet_window.h"
#include "surface/plane.h"

#include <span>

namespace vp::find
{

// Returns true if floodSpans() takes the grid: its rows are not longer than a SpanStore can hold.
bool floodTakes(const grid::Lattice& lattice);

// The traversal of a lattice by runs instead of cells. The nodes of the graph are runs of cut cells along i, which end
// at a uniform column: so no two overlap, and which there are does not depend on the order they are found in. A run
// is followed to both ends from any of its cells; each run of cut faces towards a neighboring row leads to a run
// there. The cells are those of breadthFirst(), in no generations.
//
// With a window (or null), a run is left only across faces of cells whose section reaches into it. Spans hold cells
// beside the window then, marked as left out: they stay for the edges that their points own.
//
// seeds: any cells; those that are not cut do no harm. On all cores, the same result for any number of threads. store:
// for the rows of points of this grid, and empty.
SpanCut floodSpans(const grid::CurvilinearGrid& grid, const Box& bounds, const surface::Plane& plane,
                   const seed::SheetWindow* window, std::span<const CellId> seeds, SpanStore& store);

} // namespace vp::find
