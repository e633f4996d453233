#pragma once

#include "mesh/sheet_mesh.h"
#include "session/neighborhood.h"
#include "session/rim_vertices.h"
#include "session/team.h"

#include <span>

namespace vp::session
{

/// Whether a vertex of one rank lies amid a side of another rank's polygon, as where a cell meets several smaller ones.
/// boxes: boxesOf() the team. rim: vertices that were not joined to those of others. All ranks get the same answer.
bool hangsBetweenRanks(Team& team, const std::vector<Box>& boxes, const mesh::SheetMesh& mesh,
                       std::span<const RimVertex> rim);

} // namespace vp::session
