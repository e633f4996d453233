#pragma once

#include "base/result.h"
#include "grid/block.h"
#include "slice/mesh.h"
#include "traverse/bfs.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace vp::slice
{

// An input error that lists the names there are, where no patch of the set has this one, or none of its faces could be
// found. Faces that could not are told in a word. The caller names the option.
Status checkPatch(const grid::BlockSet& blocks, const std::string& name);

// The cells behind the faces of the patches of a name, a list a block, as if each had been found in one step of a
// traversal. `admits` (per block, or empty) may turn cells down.
std::vector<traverse::LaneCut> patchCells(const grid::BlockSet& blocks, const std::string& name,
                                          std::span<const std::function<bool(CellId)>> admits = {});

// The faces themselves, of those cells, facing out of them; vertices are grid points. Faces without area are left out.
SheetMesh patchMesh(const grid::BlockSet& blocks, const std::string& name, std::span<const traverse::LaneCut> cells);

} // namespace vp::slice
