#include "exhaustive.h"
#include "test_grids.h"

#include "locate/fence_hop.h"
#include "locate/segment.h"

#include <gtest/gtest.h>

namespace vp::test
{

using locate::Hop;
using locate::Segment;

TEST(FenceHop, GoesStraightThroughAnImage)
{
	const auto& grid = std::get<grid::UniformGrid>(gridNamed("blob").grid);
	const CellId from = grid.cell(0, 3, 3);
	const CellId to = grid.cell(7, 3, 3);
	const Hop hop = locate::fenceHop(grid, from, cellCenter(grid, to), 100);
	EXPECT_EQ(hop.end, Hop::End::found);
	EXPECT_EQ(hop.cell, to);
	EXPECT_EQ(hop.hops, 7u);
	EXPECT_EQ(locate::fenceHop(grid, to, cellCenter(grid, to), 100).hops, 0u);
}

TEST(FenceHop, TellsByWhichFaceItLeft)
{
	const auto& grid = std::get<grid::UniformGrid>(gridNamed("blob").grid);
	const CellId from = grid.cell(4, 4, 4);
	for (int axis = 0; axis < 3; ++axis)
		for (const double sign : {-1.0, 1.0})
		{
			Vec3 target = cellCenter(grid, from);
			target[axis] += 100.0 * sign;
			const Hop hop = locate::fenceHop(grid, from, target, 100);
			EXPECT_EQ(hop.end, Hop::End::left_grid);
			EXPECT_EQ(hop.face, 2 * axis + (sign > 0.0));
			bool inner = false;
			grid.forEachNeighbor(hop.cell, hop.face, [&](CellId) { inner = true; });
			EXPECT_FALSE(inner);
		}
}

TEST(FenceHop, StopsAfterItsBudget)
{
	const auto& grid = std::get<grid::UniformGrid>(gridNamed("blob").grid);
	const Hop hop = locate::fenceHop(grid, grid.cell(0, 0, 0), cellCenter(grid, grid.cell(7, 7, 7)), 3);
	EXPECT_EQ(hop.end, Hop::End::looped);
	EXPECT_LE(hop.hops, 4u);
}

// Faces of infinite extent are a poor likeness of twisted cells: hops may circle there, but must end.
TEST(FenceHop, CirclesAreBroken)
{
	std::mt19937 random(1);
	for (const double jitter : {0.4, 0.7, 1.5})
	{
		constexpr int n = 6;
		std::uniform_real_distribution<double> moved(-jitter, jitter);
		std::vector<double> xyz;
		for (int k = 0; k <= n; ++k)
			for (int j = 0; j <= n; ++j)
				for (int i = 0; i <= n; ++i)
					for (const int at : {i, j, k})
						xyz.push_back(at + moved(random));
		const grid::CurvilinearGrid grid({n + 1, n + 1, n + 1}, grid::Points(Array<double>(xyz)));
		std::uniform_int_distribution<CellId> any_cell(0, n * n * n - 1);
		for (int i = 0; i < 2000; ++i)
		{
			const Vec3 target = randomPoint({Vec3(0.0), Vec3(n)}, random);
			// Cell by cell, a hop of 216 cells that has not circled ends; Brent's marks find a circle within three
			// times its way.
			EXPECT_LE(locate::fenceHop(grid, any_cell(random), target, 100000).hops, 3u * 216u);
		}
	}
}

TEST(Segment, CrossesBoxes)
{
	const Box box{Vec3(0.0), Vec3(1.0)};
	EXPECT_TRUE(locate::crossesBox({{-1.0, 0.5, 0.5}, {2.0, 0.5, 0.5}}, box));
	EXPECT_TRUE(locate::crossesBox({{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}}, box));
	EXPECT_TRUE(locate::crossesBox({{-1.0, 1.0, 0.5}, {2.0, 1.0, 0.5}}, box));   // along a side
	EXPECT_FALSE(locate::crossesBox({{-1.0, 0.5, 0.5}, {-0.1, 0.5, 0.5}}, box)); // ends before
	EXPECT_FALSE(locate::crossesBox({{-1.0, 1.1, 0.5}, {2.0, 1.1, 0.5}}, box));
	EXPECT_FALSE(locate::crossesBox({{1.5, -0.2, 0.5}, {2.7, 1.0, 0.5}}, box));
	EXPECT_TRUE(locate::crossesBox({{0.2, 0.2, 0.2}, {0.2, 0.2, 0.2}}, box)); // a point
}

TEST(Segment, CrossesTriangles)
{
	const Vec3 a(0, 0, 0);
	const Vec3 b(1, 0, 0);
	const Vec3 c(0, 1, 0);
	EXPECT_DOUBLE_EQ(locate::crossTriangle({{0.2, 0.2, -1.0}, {0.2, 0.2, 3.0}}, a, b, c), 0.25);
	EXPECT_DOUBLE_EQ(locate::crossTriangle({{0.2, 0.2, 3.0}, {0.2, 0.2, -1.0}}, a, b, c), 0.75);
	EXPECT_EQ(locate::crossTriangle({{0.6, 0.6, -1.0}, {0.6, 0.6, 1.0}}, a, b, c), locate::kNoCrossing);
	EXPECT_EQ(locate::crossTriangle({{0.2, 0.2, 0.5}, {0.2, 0.2, 1.0}}, a, b, c), locate::kNoCrossing);
	EXPECT_EQ(locate::crossTriangle({{-1.0, 0.2, 0.0}, {1.0, 0.2, 0.0}}, a, b, c), locate::kNoCrossing); // lies in it
	EXPECT_DOUBLE_EQ(locate::crossTriangle({{0.5, 0.5, -1.0}, {0.5, 0.5, 1.0}}, a, b, c), 0.5); // the rim counts
}

} // namespace vp::test
