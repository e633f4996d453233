#pragma once

#include "slice/slicer.h"

#include <span>
#include <vector>

namespace vp::slice
{

// What was found of a sheet, for meshes; both must outlive it. cuts: the sheet's own, or a part of them.
std::vector<BlockCut> blockCuts(std::span<const traverse::LaneCut> cuts, const SheetSlice& sheet);

} // namespace vp::slice
