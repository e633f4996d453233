#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "ranks/join/borders.h"
#include "ranks/ranks.h"

namespace vp::ranks
{

/// Joins the surfaces around whole cells (mesh/crinkle.h) that the ranks have. A face between two ranks that both show
/// the cell on their side is dropped at both. Vertices at one place with the same values are counted once. Faces lie on
/// each other as in grid/interfaces.h.
///
/// Pieces are not counted. One process has no borders, and nothing is changed.
Borders joinWholeCells(const Ranks& ranks, const grid::BlockSet& blocks, mesh::SheetMesh& crinkle);

} // namespace vp::ranks
