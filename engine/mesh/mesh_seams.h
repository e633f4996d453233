#pragma once

#include "base/union_find.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"

namespace vp::mesh
{

/// The seams at which the cells of a cut's polygons meet: what grid::matchInterfaces() would find among them, where the
/// blocks know no neighbors. `joined`: vertices at one grid point are one.
///
/// Around a vertex whose cells all lie in one block, the polygons close a ring. So what lies at a seam has vertices
/// around which none is closed. Only the faces of cells there are matched, and these exactly. Time follows the cut, and
/// a search only its rim.
grid::Interfaces seamsOfMesh(const grid::BlockSet& blocks, const SheetMesh& mesh, UnionFind& joined);

} // namespace vp::mesh
