#pragma once

#include "slice/slicer.h"

#include <span>
#include <vector>

namespace vp::slice
{

// What was found of a sheet, for meshes: as spans where there are, else as cells. The sheet must outlive it.
std::vector<BlockCut> blockCuts(const SheetSlice& sheet);

// The same of some cells of each block; both must outlive it.
std::vector<BlockCut> cellCuts(std::span<const traverse::LaneCut> cuts, const SheetSlice& sheet);

} // namespace vp::slice
