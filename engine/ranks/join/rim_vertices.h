#pragma once

#include "find/block_cut.h"
#include "grid/block.h"
#include "mesh/sheet_mesh.h"
#include "ranks/join/rim_vertex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::ranks
{

/// The vertices around which the polygons of the mesh close no ring. cuts: what was found in each block; a cell that
/// the sheet meets in a point or a line has no polygon, and yet joins vertices, also those of other ranks alone: behind
/// the mesh's own vertices come those that are not in it. components: per vertex, its piece of
/// the mesh. Of a curved surface, also those at grid points where others have cells: there it may touch another part of
/// itself in a point alone. others: boxesOfOthers().
std::vector<RimVertex> rimVertices(const grid::BlockSet& blocks, std::span<const std::uint32_t> whole,
                                   std::span<const find::BlockCut> cuts, std::span<const std::uint32_t> components,
                                   std::span<const Box> others, const mesh::SheetMesh& mesh);

} // namespace vp::ranks
