#pragma once

#include "cut/cut.h"
#include "mesh/sheet_mesh.h"

#include <vector>

namespace vp::cut
{

/// Returns for each polygon of a sheet's mesh the generation of the traversal, from 0, in which its cell was found. NaN
/// for faces that lie in the surface, since their cells are not cut, and for cells that were found without generations.
std::vector<double> polygonGenerations(const SheetCut& sheet, const mesh::SheetMesh& mesh);

} // namespace vp::cut
