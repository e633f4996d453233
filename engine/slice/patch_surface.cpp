#include "slice/patch_surface.h"

#include "base/log.h"
#include "slice/face_mesh.h"
#include "slice/join_vertices.h"
#include "slice/tidy_polygons.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vp::slice
{

namespace
{

// The faces of the patches of a name in one block.
std::vector<grid::Patch::Face> facesIn(const grid::BlockSet& blocks, const std::string& name, std::uint32_t block)
{
	std::vector<grid::Patch::Face> faces;
	for (const grid::Patch& patch : blocks.patches)
		if (patch.name == name)
			std::ranges::copy_if(patch.faces, std::back_inserter(faces),
			                     [&](const grid::Patch::Face& face) { return face.block == block; });
	return faces;
}

} // namespace

Status checkPatch(const grid::BlockSet& blocks, const std::string& name)
{
	std::vector<std::string> names;
	std::size_t faces = 0;
	std::size_t lost = 0;
	for (const grid::Patch& patch : blocks.patches)
	{
		if (std::ranges::find(names, patch.name) == names.end())
			names.push_back(patch.name);
		if (patch.name != name)
			continue;
		faces += patch.faces.size();
		lost += patch.lost;
	}
	if (lost > 0 && faces == 0)
		return Error{ExitCode::input, fmt::format("none of the {} faces of the patch {} is a boundary face of a linear "
		                                          "cell; choose another patch",
		                                          lost, name)};
	if (lost > 0)
		warn("{} of {} faces of the patch {} are no boundary faces of linear cells and left out", lost, lost + faces,
		     name);
	if (std::ranges::find(names, name) != names.end())
		return Nothing{};
	if (names.empty())
		return Error{ExitCode::input, "the input names no parts of its boundary; OpenFOAM patches and Exodus side sets "
		                              "are read"};
	return Error{ExitCode::input, fmt::format("there is no patch of that name; there are {}", fmt::join(names, ", "))};
}

std::vector<traverse::LaneCut> patchCells(const grid::BlockSet& blocks, const std::string& name,
                                          std::span<const std::function<bool(CellId)>> admits)
{
	std::vector<traverse::LaneCut> cuts;
	for (std::uint32_t b = 0; b < blocks.blocks.size(); ++b)
	{
		KeyNumbers known(0);
		std::vector<CellId> cells;
		for (const grid::Patch::Face& face : facesIn(blocks, name, b))
			if ((admits.empty() || !admits[b] || admits[b](face.cell)) && known.find(face.cell, 0).is_new)
				cells.push_back(face.cell);
		cuts.push_back(traverse::oneGeneration(std::move(cells)));
	}
	return cuts;
}

SheetMesh patchMesh(const grid::BlockSet& blocks, const std::string& name, std::span<const traverse::LaneCut> cells)
{
	SheetMesh mesh = makeFaceMesh();
	for (std::uint32_t b = 0; b < cells.size(); ++b)
		std::visit(
		    [&](const auto& grid)
		    {
			    KeyNumbers shown(cells[b].cells.size());
			    for (const CellId cell : cells[b].cells)
				    shown.find(cell, 0);
			    BlockFaces faces(grid, b, mesh);
			    grid::CellFaces of_cell;
			    for (const grid::Patch::Face& face : facesIn(blocks, name, b))
			    {
				    if (!shown.has(face.cell))
					    continue;
				    grid.cellFaces(face.cell, of_cell);
				    faces.add(face.cell, of_cell[static_cast<int>(face.face)]);
			    }
		    },
		    blocks.blocks[b].grid);
	joinVertices(blocks, mesh, true);
	tidyPolygons(mesh);
	dropUnusedVertices(mesh);
	return mesh;
}

} // namespace vp::slice
