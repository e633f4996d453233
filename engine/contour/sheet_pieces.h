#pragma once

#include "contour/clip_box.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "surface/curved.h"

#include <cstddef>
#include <span>

namespace vp::contour
{

// Drops the pieces of a mesh in the box that do not touch the sheet in its middle; returns how many are left. Pieces
// are those of measure/components.h, and what meets across a large face before several small cells hangs together too,
// where it does not share vertices. surfaces: what the mesh is the cut of, as each block sees it.
std::size_t keepOnSheet(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                        const ClipBox& box, mesh::SheetMesh& mesh);

} // namespace vp::contour
