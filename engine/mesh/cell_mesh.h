#pragma once

#include "find/generations.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "mesh/tidy_polygons.h"

namespace vp::mesh
{

// Adds the vertices and polygons of the cut cells of a block of any kind, of a plane turned to face along `normal`, of
// another surface to where the heights rise. A vertex is numbered where the order of the cells first meets its edge. On
// all cores, the same mesh for any number of threads. Surface: surface::Plane or surface::BlockSurface.
template <class Surface>
MeshCleanup addCells(const grid::Block& block, std::uint32_t number, const Surface& surface, const Vec3& normal,
                     const find::CellCut& cut, SheetMesh& mesh);

} // namespace vp::mesh
