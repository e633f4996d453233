#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "ranks/join/borders.h"
#include "ranks/team.h"

#include <cstdint>
#include <span>

namespace vp::ranks
{

/// Joins the surfaces around whole cells (mesh/crinkle.h) that the ranks have. A face between two ranks that both show
/// the cell on their side is dropped at both. Vertices at one place with the same values are counted once. Faces lie on
/// each other as in grid/interfaces.h.
///
/// whole: per block, the block that one process would have in its place. Pieces are not counted.
Borders joinWholeCells(Team& team, const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                       mesh::SheetMesh& crinkle);

} // namespace vp::ranks
