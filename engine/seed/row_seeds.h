#pragma once

#include "base/ids.h"
#include "grid/structured.h"
#include "surface/plane.h"

#include <vector>

namespace vp::seed
{

/// A cell of every run of cut cells along i, found by the side of every point: seeds that reach every piece, however
/// the grid is folded. On all cores; takes a bit a point.
std::vector<CellId> rowSeeds(const grid::CurvilinearGrid& grid, const surface::Plane& plane);

} // namespace vp::seed
