#pragma once

#include "find/span_cut.h"
#include "grid/structured.h"
#include "seed/sheet_window.h"
#include "surface/plane.h"

namespace vp::find
{

// The spans of a plane in a grid with straight axes. The paper's direct formula: along a row of points the distance
// from the plane only rises or only falls, so where it changes its sign follows from the plane's equation, and four
// rows of points give the one span of the cells between them. Nothing is searched. The result is the same for any
// number of threads. With a window (or null) only the rows near it are looked at; as in floodSpans(), spans hold cells
// beside it that are left out. Of a rectilinear grid the rows must be straight.
SpanCut rowSpans(const grid::UniformGrid& grid, const surface::Plane& plane, const seed::SheetWindow* window);
SpanCut rowSpans(const grid::RectilinearGrid& grid, const surface::Plane& plane, const seed::SheetWindow* window);

// Returns true if the coordinates along each axis always rise or always fall.
bool hasStraightRows(const grid::RectilinearGrid& grid);

} // namespace vp::find
