#pragma once

#include "mesh/sheet_mesh.h"
#include "ranks/join/borders.h"

#include <cstddef>
#include <vector>

namespace vp::ranks
{

/// Adds to a mesh, behind its own polygons, those of other ranks that have a corner in common with it, and returns
/// their number. So normals and what lies across an edge are what one process would make of them. Only places and
/// polygons of the mesh are right then. borders: joinBorders() of the mesh. of_polygons: a value for each polygon, or
/// none.
std::size_t addPolygonsAround(Team& team, const Borders& borders, mesh::SheetMesh& mesh,
                              std::vector<double>& of_polygons);

} // namespace vp::ranks
