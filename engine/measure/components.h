#pragma once

#include "base/union_find.h"
#include "mesh/sheet_mesh.h"

#include <cstddef>

namespace vp::measure
{

// The pieces of a sheet. Polygons that share a vertex belong to one piece, and so do polygons on both sides of a seam.
std::size_t countComponents(const mesh::SheetMesh& mesh);

// The vertices, joined where they are of one piece.
UnionFind joinedVertices(const mesh::SheetMesh& mesh);

} // namespace vp::measure
