#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

namespace vp::mesh
{

// The boundary of the domain: every boundary face of every block that lies on no other at a seam, as a polygon of grid
// points (edges with t = 0) that bears its cell. Corners that repeat are left out, and faces with fewer than three of
// them. Points that are one place across a seam or between blocks are one vertex (join_vertices.h). Polygons run as
// their cells' faces do, and no side is promised.
SheetMesh boundarySurface(const grid::BlockSet& blocks);

} // namespace vp::mesh
