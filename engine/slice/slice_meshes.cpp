#include "slice/slice_meshes.h"

#include "slice/crinkle.h"

namespace vp::slice
{

std::vector<BlockCut> cellCuts(std::span<const traverse::LaneCut> cuts, const SheetSlice& sheet)
{
	std::vector<BlockCut> blocks;
	for (std::size_t b = 0; b < cuts.size(); ++b)
		blocks.push_back({static_cast<std::uint32_t>(b), &cuts[b], nullptr, sheet.seeds.faces_in_plane[b]});
	return blocks;
}

std::vector<BlockCut> blockCuts(const SheetSlice& sheet)
{
	std::vector<BlockCut> blocks = cellCuts(sheet.cuts, sheet);
	for (std::size_t b = 0; b < blocks.size(); ++b)
		if (sheet.hasSpans(b))
		{
			blocks[b].cut = nullptr;
			blocks[b].spans = &*sheet.spans[b];
		}
	return blocks;
}

std::string surfaceName(const SheetSlice& sheet)
{
	return sheet.surface ? nameOf(*sheet.surface) : sheet.sheet.form->text();
}

SheetMesh Slice::mesh(const grid::BlockSet& blocks, std::size_t sheet) const
{
	const SheetSlice& cut = sheets[sheet];
	if (cut.surface)
		return surfaceMesh(blocks, *cut.surface, cut.cuts);
	SheetMesh mesh = cut.sheet.form ? buildMesh(blocks, surfacesOf(blocks, cut.sheet, cut.field), blockCuts(cut))
	                                : buildMesh(blocks, cut.sheet, blockCuts(cut));
	if (cut.sheet.window)
		clipToWindow(cut.sheet, cut.corners, mesh);
	return mesh;
}

SheetMesh Slice::crinkle(const grid::BlockSet& blocks, std::size_t sheet) const
{
	return crinkleMesh(blocks, blockCuts(sheets[sheet]));
}

} // namespace vp::slice
