#pragma once

#include "mesh/sheet_mesh.h"

#include <span>
#include <vector>

namespace vp::render
{

// Of each entry of polygon_vertices, the value of the polygon across the edge that begins there; the polygon's own
// where there is none or several, or the other has NaN. Contour lines of values that are constant in each polygon lie
// on edges.
std::vector<double> valuesAcross(const mesh::SheetMesh& mesh, std::span<const double> polygon_values);

} // namespace vp::render
