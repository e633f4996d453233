#pragma once

#include "cut/cutter.h"

#include <vector>

namespace vp::cut
{

// The generation of the traversal, from 0, in which the cell of each polygon of a sheet's mesh was met; NaN for faces
// that lie in the surface, whose cells are not cut.
std::vector<double> polygonGenerations(const SheetCut& sheet, const mesh::SheetMesh& mesh);

} // namespace vp::cut
