#include "slice/slice_meshes.h"

#include "slice/crinkle.h"

namespace vp::slice
{

std::vector<BlockCut> blockCuts(std::span<const traverse::LaneCut> cuts, const SheetSlice& sheet)
{
	std::vector<BlockCut> blocks;
	for (std::size_t b = 0; b < cuts.size(); ++b)
	{
		blocks.push_back({static_cast<std::uint32_t>(b), sheet.hasSpans(b) ? nullptr : &cuts[b],
		                  sheet.hasSpans(b) ? &*sheet.spans[b] : nullptr, sheet.seeds.faces_in_plane[b]});
	}
	return blocks;
}

SheetMesh Slice::mesh(const grid::BlockSet& blocks, std::size_t sheet) const
{
	const SheetSlice& cut = sheets[sheet];
	if (cut.surface)
		return surfaceMesh(blocks, *cut.surface, cut.cuts);
	SheetMesh mesh = buildMesh(blocks, cut.sheet, blockCuts(cut.cuts, cut));
	if (cut.sheet.window)
		clipToWindow(cut.sheet, cut.corners, mesh);
	return mesh;
}

SheetMesh Slice::crinkle(const grid::BlockSet& blocks, std::size_t sheet) const
{
	return crinkleMesh(blocks, blockCuts(sheets[sheet].cuts, sheets[sheet]));
}

} // namespace vp::slice
