#pragma once

#include "mesh/sheet_mesh.h"
#include "ranks/neighborhood.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::ranks
{

/// If faces in the plane lie on each other, only one is shown: the polygon of a cut cell, or else the first face. Drops
/// the others, and returns the cells of the faces that this rank dropped.
std::vector<mesh::BlockCell> dropFacesShownElsewhere(Team& team, const std::vector<Box>& boxes, mesh::SheetMesh& mesh);

/// Drops polygons (ascending) of a mesh, and the vertices that no other polygon has.
void dropPolygons(std::span<const std::uint32_t> dropped, mesh::SheetMesh& mesh);

} // namespace vp::ranks
