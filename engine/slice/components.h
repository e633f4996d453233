#pragma once

#include "grid/block.h"
#include "slice/mesh.h"

namespace vp::slice
{

// The pieces of a sheet: polygons that share a vertex are of one piece, and so are those on either side of a seam.
// There the vertices of both sides have ids of their own; they are one where the seam's faces have the same edge or the
// same corner.
std::size_t countComponents(const grid::BlockSet& blocks, const SheetMesh& mesh);

} // namespace vp::slice
