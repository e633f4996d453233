#pragma once

#include "cut/cutter.h"
#include "mesh/build_mesh.h"

#include <span>
#include <vector>

namespace vp::cut
{

// What was found of a sheet, for meshes: as spans where there are, else as cells. The sheet must outlive it.
std::vector<mesh::BlockCut> blockCuts(const SheetCut& sheet);

// The same of some cells of each block; both must outlive it.
std::vector<mesh::BlockCut> cellCuts(std::span<const find::CellCut> cuts, const SheetCut& sheet);

} // namespace vp::cut
