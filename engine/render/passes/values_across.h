#pragma once

#include "mesh/sheet_mesh.h"

#include <span>
#include <vector>

namespace vp::render
{

// Returns, for each entry of polygon_vertices, the value of the polygon across the edge that begins there. If there is
// none or several, or if the other has NaN, it is the polygon's own value. If values are constant in each polygon,
// contour lines lie on edges.
std::vector<double> valuesAcross(const mesh::SheetMesh& mesh, std::span<const double> polygon_values);

} // namespace vp::render
