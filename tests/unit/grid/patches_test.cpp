#include "grid/demo/demo.h"
#include "seamed_sets.h"

#include "grid/patches.h"

#include <gtest/gtest.h>

#include <set>

namespace vp::test
{

namespace
{

// The faces as polygons over points of their own, with the corners turned by one and in reverse.
grid::PatchPolygons polygonsOf(const std::string& name, const grid::Block& block,
                               const std::vector<std::pair<CellId, int>>& faces)
{
	std::vector<double> xyz;
	std::vector<std::int64_t> starts{0};
	std::vector<std::int64_t> corners;
	std::visit(
	    [&](const auto& grid)
	    {
		    grid::CellFaces of_cell;
		    for (const auto& [cell, face] : faces)
		    {
			    grid.cellFaces(cell, of_cell);
			    const auto ids = of_cell[face];
			    for (std::size_t i = 0; i < ids.size(); ++i)
			    {
				    const Vec3 at = grid.point(ids[(2 * ids.size() - i) % ids.size()]);
				    corners.push_back(static_cast<std::int64_t>(xyz.size() / 3));
				    xyz.insert(xyz.end(), {at.x, at.y, at.z});
			    }
			    starts.push_back(static_cast<std::int64_t>(corners.size()));
		    }
	    },
	    block.grid);
	return {name, grid::Points(Array<double>(std::move(xyz))), Array<std::int64_t>(std::move(starts)),
	        Array<std::int64_t>(std::move(corners))};
}

// Every so many of the boundary faces.
std::vector<std::pair<CellId, int>> someFaces(const grid::Block& block, std::size_t step)
{
	std::vector<std::pair<CellId, int>> faces;
	for (std::size_t f = 0; f < block.boundary.faces.size(); f += step)
		faces.emplace_back(block.boundary.faces[f].cell, static_cast<int>(block.boundary.faces[f].face));
	return faces;
}

} // namespace

TEST(Patches, AreTheFacesWithTheirCorners)
{
	for (const char* demo : {"shell", "tets", "mixed"})
	{
		const grid::BlockSet set = std::move(grid::makeDemo(demo, 6).value());
		const grid::Block& block = set.blocks[0];
		const auto few = someFaces(block, 7);
		const auto more = someFaces(block, 3); // some of both
		const std::vector<grid::PatchPolygons> polygons{polygonsOf("few", block, few), polygonsOf("more", block, more)};
		const std::vector<grid::Patch> patches = grid::findPatches(set, polygons);
		ASSERT_EQ(patches.size(), 2u);
		for (const auto& [patch, faces] : {std::pair{patches[0], few}, std::pair{patches[1], more}})
		{
			EXPECT_EQ(patch.lost, 0u) << demo;
			std::set<std::pair<CellId, int>> found;
			for (const grid::Patch::Face& face : patch.faces)
				found.emplace(face.cell, static_cast<int>(face.face));
			EXPECT_EQ(found, std::set(faces.begin(), faces.end())) << demo << " " << patch.name;
			EXPECT_EQ(patch.faces.size(), faces.size());
		}
		EXPECT_EQ(patches[1].name, "more");
	}
}

TEST(Patches, LoseWhatIsNotOnTheBoundary)
{
	const grid::BlockSet set = std::move(grid::makeDemo("shell", 6).value());
	const grid::Lattice lattice = grid::latticeCellsOf(set.blocks[0])->lattice();
	std::vector<std::pair<CellId, int>> faces = someFaces(set.blocks[0], 5);
	const std::size_t outer = faces.size();
	faces.emplace_back(lattice.cell(2, 2, 2), 1);
	faces.emplace_back(lattice.cell(2, 3, 2), 4);
	const grid::PatchPolygons polygons = polygonsOf("wall", set.blocks[0], faces);
	const std::vector<grid::Patch> patches = grid::findPatches(set, {&polygons, 1});
	EXPECT_EQ(patches[0].faces.size(), outer);
	EXPECT_EQ(patches[0].lost, 2u);
}

TEST(Patches, OnASeamAreOfTheFirstBlock)
{
	const grid::BlockSet set = setOfBlocks({latticeBlock(straight, 0.0, false), latticeBlock(straight, 1.0, false)});
	std::vector<std::pair<CellId, int>> faces;
	for (const grid::BoundaryIndex::Face& face : set.blocks[1].boundary.faces)
		if (face.face == 0) // u = 1, where the blocks meet
			faces.emplace_back(face.cell, 0);
	const grid::PatchPolygons polygons = polygonsOf("between", set.blocks[1], faces);
	const std::vector<grid::Patch> patches = grid::findPatches(set, {&polygons, 1});
	EXPECT_EQ(patches[0].faces.size(), std::size_t(kSteps * kSteps));
	for (const grid::Patch::Face& face : patches[0].faces)
	{
		EXPECT_EQ(face.block, 0u);
		EXPECT_EQ(face.face, 1u);
	}
}

} // namespace vp::test
