#pragma once

#include "base/result.h"
#include "mesh/sheet_mesh.h"
#include "ranks/join/rim_vertices.h"
#include "ranks/neighborhood.h"
#include "ranks/team.h"

#include <span>
#include <string_view>

namespace vp::ranks
{

/// Returns true if a vertex of one rank lies amid a side of another rank's polygon, as where a cell meets several
/// smaller ones. boxes: boxesOf() the team. rim: vertices that were not joined to vertices of other ranks. All ranks
/// get the same answer.
bool hangsBetweenRanks(Team& team, const std::vector<Box>& boxes, const mesh::SheetMesh& mesh,
                       std::span<const RimVertex> rim);

/// The error where cells of different sizes meet between ranks. option: a key of the view that cannot be had then;
/// empty: nothing can.
Error sizesDiffer(std::string_view option = {});

} // namespace vp::ranks
