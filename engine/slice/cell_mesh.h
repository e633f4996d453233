#pragma once

#include "grid/block.h"
#include "slice/mesh.h"
#include "surface/plane.h"
#include "traverse/bfs.h"

namespace vp::slice
{

// Adds the vertices and polygons of the cut cells of a block of any kind. A vertex is numbered where the order of the
// cells first meets its edge. On all cores, the same mesh for any number of threads.
void addCells(const grid::Block& block, std::uint32_t number, const surface::Plane& plane, const traverse::LaneCut& cut,
              SheetMesh& mesh);

} // namespace vp::slice
