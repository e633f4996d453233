#include "slice/other_surface.h"

#include "slice/grid_surface.h"
#include "slice/patch_surface.h"

namespace vp::slice
{

std::string nameOf(const OtherSurface& surface)
{
	if (const auto* patch = std::get_if<PatchName>(&surface))
		return "patch=" + patch->name;
	return surface::nameOf(std::get<surface::GridIndex>(surface));
}

std::vector<traverse::LaneCut> surfaceCells(const grid::BlockSet& blocks, const OtherSurface& surface,
                                            std::span<const std::function<bool(CellId)>> admits)
{
	if (const auto* patch = std::get_if<PatchName>(&surface))
		return patchCells(blocks, patch->name, admits);
	return gridSurfaceCells(blocks, std::get<surface::GridIndex>(surface), admits);
}

SheetMesh surfaceMesh(const grid::BlockSet& blocks, const OtherSurface& surface,
                      std::span<const traverse::LaneCut> cells)
{
	if (const auto* patch = std::get_if<PatchName>(&surface))
		return patchMesh(blocks, patch->name, cells);
	return gridSurfaceMesh(blocks, std::get<surface::GridIndex>(surface), cells);
}

} // namespace vp::slice
