#include "cut/cut.h"

#include "find/curved_sheet.h"
#include "mesh/build_mesh.h"
#include "mesh/crinkle.h"
#include "mesh/listed_mesh.h"

namespace vp::cut
{

namespace
{

std::vector<mesh::ShownBlock> shownBlocks(const SheetCut& sheet)
{
	std::vector<mesh::ShownBlock> blocks;
	for (std::uint32_t b = 0; b < sheet.cuts.size(); ++b)
		blocks.push_back(mesh::shownBlock(b, sheet.cuts[b], sheet.seeds.faces_in_plane[b]));
	return blocks;
}

} // namespace

std::string surfaceName(const SheetCut& sheet)
{
	return sheet.surface ? find::nameOf(*sheet.surface) : sheet.sheet.form->text();
}

mesh::SheetMesh Cut::mesh(const grid::BlockSet& whole, std::size_t number) const
{
	const grid::BlockSet& blocks = blocksOf(whole);
	const SheetCut& sheet = sheets[number];
	if (sheet.surface)
		return mesh::listedMesh(blocks, *sheet.surface, sheet.cuts);
	mesh::SheetMesh mesh = sheet.sheet.form
	                           ? mesh::buildMesh(blocks, find::surfacesOf(blocks, sheet.sheet, sheet.field),
	                                             shownBlocks(sheet), sheet.hanging)
	                           : mesh::buildMesh(blocks, sheet.sheet, shownBlocks(sheet), sheet.hanging);
	if (sheet.sheet.window)
		mesh::clipToWindow(sheet.sheet, sheet.corners, mesh);
	return mesh;
}

mesh::SheetMesh Cut::crinkle(const grid::BlockSet& blocks, std::size_t number) const
{
	return mesh::crinkleMesh(blocksOf(blocks), shownBlocks(sheets[number]));
}

} // namespace vp::cut
