#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "slice/mesh.h"
#include "surface/grid_index.h"
#include "traverse/bfs.h"

#include <functional>
#include <span>
#include <vector>

namespace vp::slice
{

// Whether a range of grid surfaces can be shown: some block has subscripts (an input error else), and the largest along
// that axis reaches as far (a usage error that names the range). The caller names the option.
Status checkGridIndex(const grid::BlockSet& blocks, const surface::GridIndexRange& range);

// The cells that a grid surface shows, a list a block, as if each had been found in one step of a traversal: those of
// the layer it lies in. Where it lies between two layers a cell of the low side (at index 0 of the one above), or,
// where that is hidden, the one on the other side. Blocks without subscripts, or that end before the index, have none.
// Of two such surfaces on one seam the first block's shows. `admits` (per block, or empty) may turn cells down.
// Time follows the surface.
std::vector<traverse::LaneCut> gridSurfaceCells(const grid::BlockSet& blocks, const surface::GridIndex& at,
                                                std::span<const std::function<bool(CellId)>> admits = {});

// The surface within those cells: a quadrilateral each, with vertices on the cells' edges along the axis, where point
// arrays are linear; shared by all cells around an edge. Seen from where the index grows they wind counter-clockwise.
// Quadrilaterals without area, as at the axis of a polar grid, are left out.
SheetMesh gridSurfaceMesh(const grid::BlockSet& blocks, const surface::GridIndex& at,
                          std::span<const traverse::LaneCut> cells);

} // namespace vp::slice
