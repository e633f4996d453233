#pragma once

#include "find/block_cut.h"
#include "find/listed.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <span>
#include <string>

namespace vp::mesh
{

/// The surface within those cells: a quadrilateral each, with vertices on the cells' edges along the axis, where point
/// arrays are linear; shared by all cells around an edge. Seen from where the index grows they wind counter-clockwise.
/// Quadrilaterals without area, as at the axis of a polar grid, are left out.
SheetMesh gridIndexMesh(const grid::BlockSet& blocks, const surface::GridIndex& at,
                        std::span<const find::BlockCut> cuts);

/// The faces themselves, of those cells, facing out of them; vertices are grid points. Faces without area are left out.
SheetMesh patchMesh(const grid::BlockSet& blocks, const std::string& name, std::span<const find::BlockCut> cuts);

/// The mesh of either, of what find::listedCells() gives.
SheetMesh listedMesh(const grid::BlockSet& blocks, const find::ListedSurface& surface,
                     std::span<const find::BlockCut> cuts);

} // namespace vp::mesh
