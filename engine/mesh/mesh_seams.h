#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "mesh/union_find.h"

namespace vp::mesh
{

/// The seams at which the cells of a cut's polygons meet: what grid::matchInterfaces() would find among them, where the
/// blocks know no neighbors. `joined`: vertices at one grid point are one.
///
/// A polygon's edge lies in a face of its cell. Where that face has another cell of its block across, the other's
/// polygon has the same edge the other way round. So the boundary faces are among those of the edges between vertices
/// that no ring of polygons closes around; these few are matched exactly. Time follows the cut, with no search for most
/// of it.
grid::Interfaces seamsOfMesh(const grid::BlockSet& blocks, const SheetMesh& mesh, UnionFind& joined);

} // namespace vp::mesh
