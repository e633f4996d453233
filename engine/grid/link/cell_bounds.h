#pragma once

#include "base/vec.h"
#include "grid/cell_list.h"
#include "grid/points.h"

namespace vp::grid
{

/// The bounds of the points that sliceable cells of a list have, as far as they are finite numbers. On all cores.
///
/// The bounds of all points are taken first. They are right where some cell has a point on each of the six sides, which
/// is found at once in most lists; otherwise points of no cell stick out, and the points of the cells are marked.
Box boundsOfCells(const Points& points, const CellList& cells);

/// The bounds of the first `count` points, as far as they are finite numbers. On all cores.
Box boundsOfPoints(const Points& points, std::size_t count);

} // namespace vp::grid
