#pragma once

#include "grid/block.h"
#include "slice/mesh.h"
#include "surface/grid_index.h"
#include "traverse/bfs.h"

#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace vp::slice
{

// The patches of the boundary that have a name, see grid/patches.h.
struct PatchName
{
	std::string name;

	bool operator==(const PatchName&) const = default;
};

// What is shown in place of a probe's sheets, and found without a traversal: see grid_surface.h and patch_surface.h,
// whose checks it has passed.
using OtherSurface = std::variant<surface::GridIndex, PatchName>;

std::string nameOf(const OtherSurface& surface); // "i=12.5", "patch=inlet"

std::vector<traverse::LaneCut> surfaceCells(const grid::BlockSet& blocks, const OtherSurface& surface,
                                            std::span<const std::function<bool(CellId)>> admits);
SheetMesh surfaceMesh(const grid::BlockSet& blocks, const OtherSurface& surface,
                      std::span<const traverse::LaneCut> cells);

} // namespace vp::slice
