#pragma once

#include "grid/block.h"
#include "slice/mesh.h"
#include "slice/tidy_polygons.h"
#include "surface/plane.h"
#include "traverse/bfs.h"

namespace vp::slice
{

// Adds the vertices and polygons of the cut cells of a block of any kind, turned to face along `normal`. A vertex is
// numbered where the order of the cells first meets its edge. On all cores, the same mesh for any number of threads.
MeshDoubts addCells(const grid::Block& block, std::uint32_t number, const surface::Plane& plane, const Vec3& normal,
                    const traverse::LaneCut& cut, SheetMesh& mesh);

} // namespace vp::slice
