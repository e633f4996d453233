#pragma once

#include "grid/block.h"
#include "mesh/sheet_mesh.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace vp::mesh
{

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;

// The vertices that lie on each other where the polygons of a mesh meet across a seam of the interfaces: both on the
// same edge of the seam's faces, or on the same corner. Takes time that follows the cut of the seams.
std::vector<VertexPair> seamVertices(const grid::BlockSet& blocks, const grid::Interfaces& interfaces,
                                     const SheetMesh& mesh);

} // namespace vp::mesh
