#pragma once

#include "base/exact_sum.h"
#include "mesh/sheet_mesh.h"

#include <map>
#include <span>

namespace vp::measure
{

/// The area of each value. Sums are exact, so they do not depend on how a sheet is parted.
using ValueAreas = std::map<double, ExactSum>;

/// Returns the area of each value that polygons have: of the polygons of cells, without boundary faces in the plane,
/// and without NaN.
ValueAreas valueAreas(const mesh::SheetMesh& mesh, std::span<const double> polygon_values);

} // namespace vp::measure
