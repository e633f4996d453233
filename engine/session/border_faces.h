#pragma once

#include "mesh/sheet_mesh.h"
#include "session/neighborhood.h"

#include <cstddef>
#include <vector>

namespace vp::session
{

/// Of faces in the plane that lie on each other, one is shown: the polygon of a cut cell, or the first. Returns how
/// many were dropped here.
std::size_t dropFacesShownElsewhere(Team& team, const std::vector<Box>& boxes, mesh::SheetMesh& mesh);

} // namespace vp::session
