#include "exhaustive.h"
#include "test_grids.h"

#include "locate/place.h"
#include "tries.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

using locate::Place;
using locate::PlaceFinder;

grid::BlockSet setOf(std::initializer_list<grid::Block> blocks)
{
	grid::BlockSet set;
	set.blocks = blocks;
	return set;
}

grid::Block boxed(double from)
{
	grid::Block block;
	block.grid = grid::UniformGrid({5, 5, 5}, Vec3(from, 0.0, 0.0), Vec3(1.0));
	grid::finishBlock(block);
	return block;
}

double linearIn(const grid::Block& block, const Place& place)
{
	double sum = 0.0;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          for (std::size_t i = 0; i < place.weights.points.size(); ++i)
			          sum += place.weights.weights[i] * linearAt(grid.point(place.weights.points[i]));
	          });
	return sum;
}

} // namespace

TEST(PlaceFinder, FindsWhatIsInside)
{
	for (const grid::Block& block : allGrids())
	{
		const BruteForceLocator locator(block);
		const grid::BlockSet set = setOf({block});
		PlaceFinder finder(set);
		std::mt19937 random(21);
		int inside = 0;
		for (int i = 0; i < 500; ++i)
		{
			const Vec3 point = randomPoint(block.bounds, random);
			if (locator.cellsHolding(point).empty())
				continue;
			++inside;
			const Place& place = finder.find(point);
			ASSERT_TRUE(place.found()) << block.name;
			EXPECT_NEAR(linearIn(block, place), linearAt(point), 1e-10) << block.name;
		}
		EXPECT_GT(inside, 50) << block.name;
	}
}

// Corners, and the middles of edges and faces: where cells meet, and where collapsed ones have no volume nearby.
TEST(PlaceFinder, FindsWhatLiesWhereCellsMeet)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf({block});
		PlaceFinder finder(set);
		for (CellId c = 0; c < cellCount(block); c += tryEvery())
			for (const Tetrahedron& part : cellTetrahedra(block, c))
				for (const Vec3& point : {part[1], part[2], glm::mix(part[2], part[3], 0.5)})
				{
					const Place& place = finder.find(point);
					ASSERT_TRUE(place.found()) << block.name << " " << c;
					EXPECT_NEAR(linearIn(block, place), linearAt(point), 1e-9) << block.name << " " << c;
					for (const double weight : place.weights.weights)
						EXPECT_GT(weight, -1e-6) << block.name << " " << c; // nothing is extrapolated
				}
	}
}

TEST(PlaceFinder, APointOnAFaceBelongsToOneCell)
{
	const grid::BlockSet set = setOf({boxed(0.0)});
	const auto& grid = std::get<grid::UniformGrid>(set.blocks[0].grid);
	PlaceFinder finder(set);
	for (const Vec3& point : {Vec3(2.0, 1.5, 1.5), Vec3(2.0, 2.0, 1.5), Vec3(2.0, 2.0, 2.0), Vec3(0.0), Vec3(4.0)})
	{
		const Vec3 low = glm::max(glm::ceil(point) - 1.0, Vec3(0.0));
		const CellId lowest = grid.cell(static_cast<std::uint32_t>(low.x), static_cast<std::uint32_t>(low.y),
		                                static_cast<std::uint32_t>(low.z));
		for (const Vec3& before : {Vec3(0.1), Vec3(3.9), Vec3(3.9, 0.1, 3.9), Vec3(2.1, 2.1, 2.1), Vec3(9.0)})
		{
			finder.find(before);
			EXPECT_EQ(finder.find(point).cell, lowest);
		}
	}
}

TEST(PlaceFinder, TheTreeFindsInOneBlockWhatHopsFind)
{
	const grid::BlockSet set = setOf({boxed(3.0), gridNamed("mixed"), boxed(0.0)});
	PlaceFinder finder(set);
	EXPECT_FALSE(finder.findByTree(0, Vec3(0.5)).found());
	EXPECT_EQ(finder.findByTree(2, Vec3(0.5)).block, 2u);
	std::mt19937 random(22);
	for (int i = 0; i < 100; ++i)
	{
		const Vec3 point = randomPoint(set.blocks[1].bounds, random);
		const Place& place = finder.findByTree(1, point);
		ASSERT_TRUE(place.found());
		EXPECT_NEAR(linearIn(set.blocks[1], place), linearAt(point), 1e-10);
	}
}

TEST(PlaceFinder, CellsBehindTheBoundaryAreFoundAlongIt)
{
	const grid::BlockSet set = setOf({gridNamed("two_pieces")}); // x to 1/3, and from 2/3
	PlaceFinder finder(set);
	const CellId cell = finder.find({0.3, 0.4, 0.4}).cell;
	constexpr double kReach = 0.01;
	EXPECT_EQ(finder.findAtBoundary(0, {0.33, 0.4, 0.4}, kReach, kNoCell).cell, cell);
	EXPECT_FALSE(finder.findAtBoundary(0, {0.33, 0.4, 0.4}, kReach, cell).found());
	EXPECT_FALSE(finder.findAtBoundary(0, {0.34, 0.4, 0.4}, kReach, kNoCell).found());
}

TEST(PlaceFinder, BlocksAreAskedInOrder)
{
	const grid::BlockSet set = setOf({boxed(3.0), boxed(0.0)});
	PlaceFinder finder(set);
	EXPECT_EQ(finder.find(Vec3(3.5)).block, 0u); // both hold it
	EXPECT_EQ(finder.find(Vec3(0.5)).block, 1u);
	EXPECT_FALSE(finder.find(Vec3(-0.1, 1.0, 1.0)).found());
	EXPECT_FALSE(finder.find(Vec3(8.0)).found());
	EXPECT_EQ(finder.find(Vec3(6.5, 1.5, 1.5)).block, 0u);
}

TEST(PlaceFinder, AFlatBoundaryIsSharp)
{
	const grid::BlockSet set = setOf({boxed(0.0)});
	PlaceFinder finder(set);
	EXPECT_TRUE(finder.find({4.0, 2.2, 2.2}).found());
	EXPECT_FALSE(finder.find({4.0 + 1e-6, 2.2, 2.2}).found());
	EXPECT_FALSE(finder.find(Vec3(std::numeric_limits<double>::quiet_NaN())).found());
}

// Missing cells within the bounds count as outside.
TEST(PlaceFinder, HiddenCellsAreOutside)
{
	const grid::BlockSet set = setOf({gridNamed("two_pieces")});
	PlaceFinder finder(set);
	EXPECT_TRUE(finder.find({0.1, 0.5, 0.5}).found());
	EXPECT_FALSE(finder.find({0.5, 0.5, 0.5}).found());
	EXPECT_TRUE(finder.find({0.9, 0.5, 0.5}).found());
}

} // namespace vp::test
