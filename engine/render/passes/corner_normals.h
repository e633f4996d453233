#pragma once

#include "mesh/sheet_mesh.h"

#include <vector>

namespace vp::render
{

// A unit normal at each entry of polygon_vertices, on the side of the polygon's own: the mean, by area, over the
// polygons about the vertex that meet it at less than kFeatureAngle, whichever way round they are. Zero for
// polygons without area. It does not depend on the order of the polygons.
std::vector<Vec3f> cornerNormals(const mesh::SheetMesh& mesh);

} // namespace vp::render
