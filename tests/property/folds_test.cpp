#include "lattice_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"

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

// The list holds the folded part of the grid, not the whole grid.
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

// Five tetrahedra in each box of a lattice, as programs write them: the middle one, or every one of some boxes, runs
// the other way round. A point that is pulled through the opposite side of its cells folds the grid there.
TEST(Folds, AreFoundAmongCellsNumberedBothWays)
{
	constexpr int n = 4;
	const auto build = [&](bool folded)
	{
		CellListMaker maker;
		for (int k = 0; k <= n; ++k)
			for (int j = 0; j <= n; ++j)
				for (int i = 0; i <= n; ++i)
					maker.point(folded && i == 2 && j == 2 && k == 2 ? Vec3(2.0, 2.0, 3.4) : Vec3(i, j, k));
		const auto id = [=](int i, int j, int k) { return static_cast<std::int64_t>((k * (n + 1) + j) * (n + 1) + i); };
		int cell = 0;
		for (int k = 0; k < n; ++k)
			for (int j = 0; j < n; ++j)
				for (int i = 0; i < n; ++i)
				{
					const std::array<std::int64_t, 8> p{
					    id(i, j, k),     id(i + 1, j, k),     id(i + 1, j + 1, k),     id(i, j + 1, k),
					    id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)};
					constexpr int kEven[5][4] = {{0, 1, 3, 4}, {1, 2, 3, 6}, {1, 4, 5, 6}, {3, 4, 6, 7}, {1, 3, 4, 6}};
					constexpr int kOdd[5][4] = {{0, 1, 2, 5}, {0, 2, 3, 7}, {0, 4, 5, 7}, {2, 5, 6, 7}, {0, 2, 5, 7}};
					for (const auto& corners : (i + j + k) % 2 ? kOdd : kEven)
					{
						std::vector<std::int64_t> points;
						for (const int corner : corners)
							points.push_back(p[corner]);
						if (++cell % 3 == 0)
							std::swap(points[0], points[1]);
						maker.cell(10, points);
					}
				}
		return maker.block("tetrahedra");
	};
	EXPECT_TRUE(build(false).inverted.empty());
	const grid::Block folded = build(true);
	EXPECT_FALSE(folded.inverted.empty());
	EXPECT_LE(folded.inverted.size(), 32u);
	grid::BlockSet set;
	set.blocks.push_back(folded);
	cut::Cutter cutter(set);
	for (int step = 1; step < 40; ++step)
	{
		const TestPlane plane{{2.5, 2.5, 0.1 * step + 0.01}, {0.02, 0.03, 1}};
		EXPECT_EQ(cut(cutter, plane).cutCells(), scanCutCells(folded, plane)) << plane.origin.z;
	}
}

} // namespace vp::test
