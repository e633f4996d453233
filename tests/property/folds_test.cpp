#include "lattice_sets.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

constexpr LatticeKind kKinds[] = {LatticeKind::curvilinear, LatticeKind::hexahedra, LatticeKind::wedges,
                                  LatticeKind::tetrahedra,  LatticeKind::pyramids,  LatticeKind::polyhedra,
                                  LatticeKind::doubles,     LatticeKind::mixed};

// 5^3 unit cells of which point (2, 2, 2) is moved.
RawSet peaked(LatticeKind kind, const Vec3& by)
{
	Draw draw(3);
	RawSet raw = latticeSet(kind, draw, {}, {5, 5});
	raw.blocks[0].points[(2 * 6 + 2) * 6 + 2] += by;
	return raw;
}

} // namespace

// The peak closes off a piece inside, though the hexahedra about it keep a positive volume.
TEST(Folds, PiecesInsideAreFound)
{
	for (const LatticeKind kind : kKinds)
		for (const double by : {1.4, -1.4, 2.3})
		{
			const grid::BlockSet set = build(peaked(kind, {0.0, 0.0, by}));
			cut::Cutter cutter(set);
			for (int step = 1; step < 50; ++step)
			{
				const TestPlane plane{{2.5, 2.5, 0.1 * step + 0.01}, {0, 0, 1}};
				EXPECT_EQ(cut(cutter, plane).cutCells(), scanCutCells(set.blocks[0], plane))
				    << "kind " << static_cast<int>(kind) << ", by " << by << ", height " << plane.origin.z;
			}
		}
	const grid::BlockSet set = build(peaked(LatticeKind::curvilinear, {0.0, 0.0, 1.4}));
	cut::Cutter cutter(set);
	EXPECT_EQ(cut(cutter, {{2.5, 2.5, 3.2}, {0, 0, 1}}).cutCellCount(), 33u);
}

TEST(Folds, AxesThatTurnBack)
{
	const std::vector<double> there_and_back{0.0, 1.0, 2.0, 1.3, 0.6, 1.5, 3.0};
	grid::Block block;
	block.grid = grid::RectilinearGrid(there_and_back, there_and_back, there_and_back);
	grid::finishBlock(block);
	const grid::BlockSet set = setOf(block);
	cut::Cutter cutter(set);
	for (const TestPlane& plane : randomPlanes(block.bounds, 100, 26))
		EXPECT_EQ(cut(cutter, plane).cutCells(), scanCutCells(block, plane));
}

// What is listed is where the grid is folded and not all of it.
TEST(Folds, OnlyCellsAboutThePeakAreListed)
{
	for (const LatticeKind kind : {LatticeKind::curvilinear, LatticeKind::hexahedra, LatticeKind::polyhedra})
	{
		EXPECT_TRUE(build(peaked(kind, Vec3(0.0))).blocks[0].inverted.empty());
		EXPECT_TRUE(build(peaked(kind, {0.2, 0.2, 0.3})).blocks[0].inverted.empty());
		const grid::BlockSet set = build(peaked(kind, {0.0, 0.0, 1.4}));
		EXPECT_GE(set.blocks[0].inverted.size(), 4u);
		EXPECT_LE(set.blocks[0].inverted.size(), kind == LatticeKind::polyhedra ? 32u : 8u);
	}
}

} // namespace vp::test
