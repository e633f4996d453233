#pragma once

#include "cut/cut.h"
#include "mesh/sheet_mesh.h"

#include <vector>

namespace vp::cut
{

/// The generation of the traversal, from 0, in which the cell of each polygon of a sheet's mesh was met; NaN for faces
/// that lie in the surface, whose cells are not cut, and for cells that were found in no generations.
std::vector<double> polygonGenerations(const SheetCut& sheet, const mesh::SheetMesh& mesh);

} // namespace vp::cut
