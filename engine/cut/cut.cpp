#include "cut/cut.h"

#include "find/curved_sheet.h"
#include "mesh/build_mesh.h"
#include "mesh/crinkle.h"
#include "mesh/listed_mesh.h"

#include <set>
#include <utility>

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

mesh::SheetMesh Cut::crinkle(const grid::BlockSet& blocks, std::size_t number,
                             std::span<const mesh::BlockCell> left_out) const
{
	std::vector<mesh::ShownBlock> shown = shownBlocks(sheets[number]);
	std::vector<std::vector<grid::BoundaryIndex::Face>> faces;
	if (!left_out.empty())
		faces = sheets[number].seeds.faces_in_plane;
	std::set<std::pair<std::uint32_t, CellId>> left;
	for (const mesh::BlockCell& cell : left_out)
		left.emplace(cell.block, cell.cell);
	for (std::uint32_t b = 0; b < faces.size(); ++b)
	{
		std::erase_if(faces[b], [&](const auto& face) { return left.contains({b, face.cell}); });
		shown[b].faces_in_plane = faces[b];
	}
	return mesh::crinkleMesh(blocksOf(blocks), shown);
}

} // namespace vp::cut
