#pragma once

#include "slice/mesh.h"

namespace vp::slice
{

// Drops repeated vertices, and polygons without area. In a flat mesh the rest is turned to run counter-clockwise about
// `normal`; in others (see SheetMesh::flat) polygons keep their sense and `normal` means nothing.
void tidyPolygons(SheetMesh& mesh, const Vec3& normal = Vec3(0.0));

} // namespace vp::slice
