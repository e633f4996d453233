#pragma once

#include "find/cell_marks.h"
#include "find/generations.h"
#include "grid/unstructured.h"
#include "surface/plane.h"

#include <span>

namespace vp::find
{

// Traverses cells of any shape without generations: whenever a core is free, it classifies a cell and queues its
// neighbors. Memory for the next cells is fetched in advance. Finds the same cells and codes as breadthFirst(), in
// ascending order of the cells. The result does not depend on the number of threads.
//
// window: or null. With a window, only cells whose section reaches into it count as cut, and the traversal goes on from
// them. Cells beside them are in the list, but not cut.
//
// bounds: of the points that cells use. seeds: any cells; cells that are not cut do no harm. marks: empty, for the
// cells of this grid.
CellCut floodCells(const grid::UnstructuredGrid& grid, const surface::Plane& plane, const Box& bounds,
                   const seed::SheetWindow* window, std::span<const CellId> seeds, CellMarks& marks);

} // namespace vp::find
