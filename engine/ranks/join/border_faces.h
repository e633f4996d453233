#pragma once

#include "mesh/sheet_mesh.h"
#include "ranks/neighborhood.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::ranks
{

/// Of faces in the plane that lie on each other, one is shown: the polygon of a cut cell, or the first. Returns the
/// cells of those that were dropped here.
std::vector<mesh::BlockCell> dropFacesShownElsewhere(Team& team, const std::vector<Box>& boxes, mesh::SheetMesh& mesh);

/// Drops polygons (ascending) of a mesh, and the vertices that no other polygon has.
void dropPolygons(std::span<const std::uint32_t> dropped, mesh::SheetMesh& mesh);

} // namespace vp::ranks
