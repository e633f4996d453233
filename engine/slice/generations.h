#pragma once

#include "slice/slicer.h"

#include <vector>

namespace vp::slice
{

// The generation of the traversal, from 0, in which the cell of each polygon of a sheet's mesh was met; NaN for faces
// that lie in the surface, whose cells are not cut.
std::vector<double> polygonGenerations(const SheetSlice& sheet, const SheetMesh& mesh);

} // namespace vp::slice
