#pragma once

#include "mesh/sheet_mesh.h"
#include "mesh/union_find.h"

#include <cstddef>

namespace vp::measure
{

// The pieces of a sheet: polygons that share a vertex are of one piece, and so are those on either side of a seam.
std::size_t countComponents(const mesh::SheetMesh& mesh);

// The vertices, joined where they are of one piece.
mesh::UnionFind joinedVertices(const mesh::SheetMesh& mesh);

} // namespace vp::measure
