#pragma once

#include "slice/mesh.h"
#include "slice/union_find.h"

#include <cstddef>

namespace vp::slice
{

// The pieces of a sheet: polygons that share a vertex are of one piece, and so are those on either side of a seam.
std::size_t countComponents(const SheetMesh& mesh);

// The vertices, joined where they are of one piece.
UnionFind joinedVertices(const SheetMesh& mesh);

} // namespace vp::slice
