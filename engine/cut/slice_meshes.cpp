#include "cut/slice_meshes.h"

#include "mesh/build_mesh.h"
#include "mesh/crinkle.h"
#include "mesh/listed_mesh.h"

namespace vp::cut
{

std::vector<mesh::BlockCut> cellCuts(std::span<const find::CellCut> cuts, const SheetCut& sheet)
{
	std::vector<mesh::BlockCut> blocks;
	for (std::size_t b = 0; b < cuts.size(); ++b)
		blocks.push_back({static_cast<std::uint32_t>(b), &cuts[b], nullptr, sheet.seeds.faces_in_plane[b]});
	return blocks;
}

std::vector<mesh::BlockCut> blockCuts(const SheetCut& sheet)
{
	std::vector<mesh::BlockCut> blocks = cellCuts(sheet.cuts, sheet);
	for (std::size_t b = 0; b < blocks.size(); ++b)
		if (sheet.hasSpans(b))
		{
			blocks[b].cut = nullptr;
			blocks[b].spans = &*sheet.spans[b];
		}
	return blocks;
}

std::string surfaceName(const SheetCut& sheet)
{
	return sheet.surface ? find::nameOf(*sheet.surface) : sheet.sheet.form->text();
}

mesh::SheetMesh Cut::mesh(const grid::BlockSet& blocks, std::size_t sheet) const
{
	const SheetCut& cut = sheets[sheet];
	if (cut.surface)
		return mesh::listedMesh(blocks, *cut.surface, cut.cuts);
	mesh::SheetMesh mesh = cut.sheet.form
	                           ? mesh::buildMesh(blocks, find::surfacesOf(blocks, cut.sheet, cut.field), blockCuts(cut))
	                           : mesh::buildMesh(blocks, cut.sheet, blockCuts(cut));
	if (cut.sheet.window)
		mesh::clipToWindow(cut.sheet, cut.corners, mesh);
	return mesh;
}

mesh::SheetMesh Cut::crinkle(const grid::BlockSet& blocks, std::size_t sheet) const
{
	return mesh::crinkleMesh(blocks, blockCuts(sheets[sheet]));
}

} // namespace vp::cut
