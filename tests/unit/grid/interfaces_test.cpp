#include "seamed_sets.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

namespace vp::test
{

namespace
{

// Every link is entered from both sides, and names faces that coincide.
void expectConsistent(const grid::BlockSet& set)
{
	ASSERT_EQ(set.interfaces.blocks.size(), set.blocks.size());
	std::size_t seams = 0;
	std::size_t boundary = 0;
	for (std::uint32_t b = 0; b < set.blocks.size(); ++b)
	{
		std::set<std::pair<CellId, std::uint32_t>> faces;
		const grid::BlockSeams& here = set.interfaces.blocks[b];
		for (const grid::SeamLink& link : here.all())
		{
			faces.emplace(link.cell, link.face);
			const auto back = set.interfaces.blocks[link.block].of(link.other, link.other_face);
			EXPECT_TRUE(
			    std::ranges::count(back, grid::SeamLink{link.other, link.other_face, b, link.cell, link.face}) == 1);
			EXPECT_EQ(here.of(link.cell, link.face).front().cell, link.cell);
		}
		seams += faces.size();
		boundary += set.blocks[b].boundary.faces.size();
	}
	EXPECT_EQ(set.interfaces.seam_faces, seams);
	EXPECT_EQ(set.interfaces.boundary_faces, boundary - seams);
}

constexpr std::size_t kSide = kSteps * kSteps;

// Boxes on one another along an axis, with points of their own, in floats. heights: of each box its lower and upper
// end. The other sides are 250 long.
grid::BlockSet stackOfBoxes(int up, const Vec3& lo, const std::vector<std::pair<double, double>>& heights)
{
	CellListMaker maker;
	std::vector<float> xyz;
	for (const auto& [low, high] : heights)
	{
		std::vector<std::int64_t> ids;
		for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
		                           Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1)})
		{
			Vec3 place;
			place[up] = corner.z > 0.0 ? high : low;
			place[(up + 1) % 3] = 250.0 * corner.x;
			place[(up + 2) % 3] = 250.0 * corner.y;
			ids.push_back(maker.point(lo + place));
			for (int axis = 0; axis < 3; ++axis)
				xyz.push_back(static_cast<float>(lo[axis] + place[axis]));
		}
		maker.cell(12, ids);
	}
	grid::Block block;
	block.grid = grid::UnstructuredGrid::build(grid::Points(Array<float>(std::move(xyz))), maker.list());
	addTestFields(block, heights.size());
	grid::finishBlock(block);
	return setOfBlocks({block});
}

// Cells are numbered in the order in which they were given.
bool meet(const grid::BlockSet& set, std::size_t a, std::size_t b)
{
	const auto& grid = std::get<grid::UnstructuredGrid>(set.blocks[0].grid);
	const grid::BlockSeams* seams = set.interfaces.of(0);
	return seams &&
	       std::ranges::any_of(seams->all(), [&](const grid::SeamLink& link)
	                           { return grid.sourceCell(link.cell) == a && grid.sourceCell(link.other) == b; });
}

} // namespace

TEST(Interfaces, BlocksWhoseIndicesRunOtherwise)
{
	for (const Place place : {straight, warped})
	{
		const grid::BlockSet set = setOfBlocks({latticeBlock(place, 0.0, false), latticeBlock(place, 1.0, true)});
		expectConsistent(set);
		ASSERT_EQ(set.interfaces.interfaces.size(), 1u);
		EXPECT_EQ(set.interfaces.interfaces[0].a, 0u);
		EXPECT_EQ(set.interfaces.interfaces[0].b, 1u);
		EXPECT_EQ(set.interfaces.interfaces[0].faces, kSide);
		EXPECT_EQ(set.interfaces.seam_faces, 2 * kSide);
		EXPECT_EQ(set.interfaces.boundary_faces, 10 * kSide);
	}
}

TEST(Interfaces, AStructuredBlockMeetsCells)
{
	const grid::BlockSet set = setOfBlocks({latticeBlock(warped, 0.0, true), hexahedraBlock(warped, 1.0, 2.0, true)});
	expectConsistent(set);
	EXPECT_EQ(set.interfaces.seam_faces, 2 * kSide);
}

TEST(Interfaces, ImagesSideBySide)
{
	grid::Block left;
	left.grid = grid::UniformGrid({4, 4, 4}, Vec3(0.0), Vec3(0.1));
	grid::finishBlock(left);
	grid::Block right;
	right.grid = grid::UniformGrid({3, 4, 4}, Vec3(0.3, 0.0, 0.0), Vec3(0.2, 0.1, 0.1));
	grid::finishBlock(right);
	const grid::BlockSet set = setOfBlocks({left, right});
	expectConsistent(set);
	EXPECT_EQ(set.interfaces.seam_faces, 18u);
}

TEST(Interfaces, TheWrapOfAnOGrid)
{
	const grid::BlockSet set = setOfBlocks({oGrid()});
	expectConsistent(set);
	ASSERT_EQ(set.interfaces.interfaces.size(), 1u);
	EXPECT_EQ(set.interfaces.interfaces[0].a, set.interfaces.interfaces[0].b);
	EXPECT_EQ(set.interfaces.interfaces[0].faces, kSide);
	EXPECT_EQ(set.interfaces.boundary_faces, 4 * 2 * kSide);
}

TEST(Interfaces, PointsThatAreNotMerged)
{
	const grid::BlockSet set = setOfBlocks({hexahedraBlock(warped, 0.0, 1.0, false)});
	expectConsistent(set);
	EXPECT_EQ(set.interfaces.boundary_faces, 6 * kSide);
	EXPECT_EQ(set.interfaces.seam_faces, 6 * kSteps * kSide - 6 * kSide);
}

TEST(Interfaces, AFaceOnSeveralIsLinkedToEach)
{
	CellListMaker maker;
	for (const Vec3& tip : {Vec3(0.2, 0.2, 1), Vec3(0.4, 0.2, 1.5), Vec3(0.3, 0.3, -1)})
		maker.cell(10, {maker.point({0, 0, 0}), maker.point({1, 0, 0}), maker.point({0, 1, 0}), maker.point(tip)});
	const grid::BlockSet set = setOfBlocks({maker.block("three")});
	expectConsistent(set);
	EXPECT_EQ(set.interfaces.seam_faces, 3u);
	EXPECT_EQ(set.interfaces.blocks[0].all().size(), 6u);
	EXPECT_EQ(set.interfaces.interfaces[0].faces, 3u);
}

TEST(Interfaces, NoneWherePointsAreMerged)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOfBlocks({block});
		expectConsistent(set);
		if (block.name != "two_to_one")
		{
			EXPECT_EQ(set.interfaces.seam_faces, 0u) << block.name;
			EXPECT_EQ(set.interfaces.of(0), nullptr);
		}
	}
}

// Cells a millionth as high as wide, far from the origin: neighbors are not taken for one another.
TEST(Interfaces, ThinCellsFarAway)
{
	for (const double height : {1e-3, 1e-6})
	{
		const auto place = [&](double u0)
		{
			return curvilinearBlock("thin", {3, 3, 5},
			                        [&](int i, int j, int k) { return Vec3(1000.0 + u0 + i, j, height * k); });
		};
		const grid::BlockSet set = setOfBlocks({place(0.0), place(2.0)});
		expectConsistent(set);
		EXPECT_EQ(set.interfaces.seam_faces, 2u * 2 * 4) << height;
	}
}

// A sheet of metal: the tolerance of its broad faces is more than its thickness.
TEST(Interfaces, TheSidesOfAFlatCellDoNotMeet)
{
	CellListMaker maker;
	std::vector<std::int64_t> ids;
	for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 1),
	                      Vec3(1, 1, 1), Vec3(0, 1, 1)})
		ids.push_back(maker.point(Vec3(p.x, p.y, 1e-7 * p.z)));
	maker.cell(12, ids);
	ids.clear();
	for (const Vec3& p : {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(1, 1, 1), Vec3(0, 1, 1), Vec3(0, 0, 2), Vec3(1, 0, 2),
	                      Vec3(1, 1, 2), Vec3(0, 1, 2)})
		ids.push_back(maker.point(Vec3(p.x, p.y, 1e-7 * p.z)));
	maker.cell(12, ids);
	grid::BlockSet set;
	set.blocks.push_back(maker.block("metal"));
	grid::matchInterfaces(set);
	EXPECT_EQ(set.interfaces.seam_faces, 2u);
	EXPECT_EQ(set.interfaces.boundary_faces, 10u);
}

TEST(Interfaces, WithinTheToleranceAndBeyond)
{
	for (const double gap : {1e-8, 1e-5})
	{
		const bool meets = gap < 1e-6;
		const auto shifted =
		    curvilinearBlock("shifted", {kSteps + 1, kSteps + 1, kSteps + 1},
		                     [&](int i, int j, int k) { return Vec3(1.0 + gap + i * 0.25, j * 0.25, k * 0.25); });
		const grid::BlockSet set = setOfBlocks({latticeBlock(straight, 0.0, false), shifted});
		EXPECT_EQ(set.interfaces.seam_faces, meets ? 2 * kSide : 0u) << gap;
	}
}

// In floats at 6.7e6, as projected coordinates in meters are, numbers are half a meter apart.
TEST(Interfaces, ToleranceFollowsEachAxis)
{
	for (int up = 0; up < 3; ++up)
		for (int far = 0; far < 3; ++far)
		{
			SCOPED_TRACE(testing::Message() << "up " << up << ", far " << far);
			Vec3 lo(0.0);
			lo[far] = 6.7e6;
			// A slab between two cells without thickness, and between two thick ones.
			const grid::BlockSet flat = stackOfBoxes(up, lo, {{0, 0}, {0, 1}, {1, 1}});
			EXPECT_FALSE(meet(flat, 0, 2));
			const grid::BlockSet thick = stackOfBoxes(up, lo, {{-100, 0}, {0, 1}, {1, 100}});
			EXPECT_TRUE(meet(thick, 0, 1));
			EXPECT_TRUE(meet(thick, 1, 2));
			EXPECT_FALSE(meet(thick, 0, 2));
			const grid::BlockSet thinnest = stackOfBoxes(up, lo, {{-100, 0}, {0, 0.5}, {0.5, 100}});
			EXPECT_TRUE(meet(thinnest, 0, 1));
			EXPECT_TRUE(meet(thinnest, 1, 2));
			EXPECT_FALSE(meet(thinnest, 0, 2));
			// Two copies of a side that differ by one number of the far axis, as rounding leaves them, are one.
			const double gap = up == far ? 0.5 : 1e-5;
			EXPECT_TRUE(meet(stackOfBoxes(up, lo, {{-100, 0}, {gap, 100}}), 0, 1));
			// Along the other axes such a gap is one.
			if (up != far)
			{
				EXPECT_FALSE(meet(stackOfBoxes(up, lo, {{-100, 0}, {0.5, 100}}), 0, 1));
			}
		}
}

// One file given many times, and the same with rounding apart: links grow with the number of faces, not with its
// square, and lead from each to all.
TEST(Interfaces, ManyBlocksAtOnePlace)
{
	constexpr std::size_t kBlocks = 200;
	for (const double apart : {0.0, 1e-9})
	{
		std::vector<grid::Block> blocks;
		for (std::size_t b = 0; b < kBlocks; ++b)
			blocks.push_back(
			    hexahedraBlock(straight, apart * static_cast<double>(b), 0.25 + apart * static_cast<double>(b), true));
		const grid::BlockSet set = setOfBlocks(std::move(blocks));
		expectConsistent(set);
		const std::size_t faces = set.blocks[0].boundary.faces.size();
		EXPECT_EQ(set.interfaces.seam_faces, kBlocks * faces);
		std::size_t links = 0;
		for (const grid::BlockSeams& seams : set.interfaces.blocks)
			links += seams.all().size();
		EXPECT_LE(links, kBlocks * faces * 8) << apart;
		for (const grid::BoundaryIndex::Face& face : set.blocks[0].boundary.faces)
		{
			std::set<std::tuple<std::uint32_t, CellId, std::uint32_t>> reached{{0, face.cell, face.face}};
			std::vector<std::tuple<std::uint32_t, CellId, std::uint32_t>> front(reached.begin(), reached.end());
			while (!front.empty())
			{
				const auto [b, cell, f] = front.back();
				front.pop_back();
				for (const grid::SeamLink& link : set.interfaces.blocks[b].of(cell, f))
					if (reached.emplace(link.block, link.other, link.other_face).second)
						front.emplace_back(link.block, link.other, link.other_face);
			}
			EXPECT_EQ(reached.size(), kBlocks) << apart;
		}
	}
}

} // namespace vp::test
