#pragma once

#include "find/cell_marks.h"
#include "find/generations.h"
#include "grid/unstructured.h"
#include "surface/plane.h"

#include <span>

namespace vp::find
{

// The traversal of cells of any shape in no generations: a cell is classified, and its neighbors queued, whenever a
// core is free, with what comes next fetched from memory in advance. Cells and codes are those of breadthFirst(), in
// ascending order of the cells: the same for any number of threads.
//
// With a window (or null) only cells whose section reaches into it count as cut and are left; those beside them are in
// the list, not cut.
//
// bounds: of the points that cells have. seeds: any cells; those that are not cut do no harm. marks: for the cells of
// this grid, and empty.
CellCut floodCells(const grid::UnstructuredGrid& grid, const surface::Plane& plane, const Box& bounds,
                   const seed::SheetWindow* window, std::span<const CellId> seeds, CellMarks& marks);

} // namespace vp::find
