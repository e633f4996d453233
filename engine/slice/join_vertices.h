#pragma once

#include "grid/block.h"
#include "slice/mesh.h"

namespace vp::slice
{

// Makes one vertex of those that are one place under several names, so that what closes up in space closes up in the
// mesh: edges cut at the same grid point; edges that lie on each other at a seam; and, between several blocks, vertices
// at exactly the same place. Vertices whose point arrays differ stay apart, so that a jump of the data survives; those
// of a seam are then listed in mesh.seam_pairs. Vertices out of use stay in the mesh.
void joinVertices(const grid::BlockSet& blocks, SheetMesh& mesh);

} // namespace vp::slice
