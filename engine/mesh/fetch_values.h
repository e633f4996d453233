#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <span>

namespace vp::mesh
{

// Reads what the vertices or polygons of a mesh need of arrays that stay in their files, all at once, so that no thread
// waits for one part after the other. Does nothing for arrays in memory. fields: per block, null where a block lacks
// it. Throws parts::Unreadable.
void fetchValues(const grid::BlockSet& blocks, const SheetMesh& mesh, std::span<const grid::Field* const> fields);

} // namespace vp::mesh
