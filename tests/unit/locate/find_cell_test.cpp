#include "exhaustive.h"
#include "test_grids.h"

#include "locate/find_cell.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// Grids whose faces are flat: fence hopping's planes are the faces. Cells of the others may be told apart otherwise
// than by the planes that fit their faces.
bool hasFlatFaces(const grid::Block& block)
{
	for (const char* name : {"blob", "graded", "tets", "mixed", "collapsed_axis", "collapsed_hexahedra", "inverted",
	                         "hexagonal_prisms", "two_to_one", "u_shape", "two_pieces"})
		if (block.name == name)
			return true;
	return false;
}

// A point well inside a tetrahedron of a cell, drawn towards the cell's center by `pull`.
Vec3 pointInside(const BruteForceLocator& locator, CellId cell, double pull, std::mt19937& random)
{
	std::vector<Tetrahedron> parts = locator.parts(cell);
	const auto smaller = [](const Tetrahedron& a, const Tetrahedron& b)
	{ return std::abs(volumeOf(a)) < std::abs(volumeOf(b)); };
	const double largest = std::abs(volumeOf(*std::ranges::max_element(parts, smaller)));
	std::erase_if(parts,
	              [&](const Tetrahedron& part) { return std::abs(volumeOf(part)) < 1e-9 * largest; }); // collapsed
	const Tetrahedron& part = parts[std::uniform_int_distribution<std::size_t>(0, parts.size() - 1)(random)];
	std::uniform_real_distribution<double> weight(0.1, 1.0);
	Vec3 sum(0.0);
	double weights = 0.0;
	for (const Vec3& corner : part)
	{
		const double w = weight(random);
		sum += w * corner;
		weights += w;
	}
	return glm::mix(sum / weights, part[0], pull);
}

std::size_t budget(const grid::Block& block)
{
	return static_cast<std::size_t>(6.0 * std::cbrt(static_cast<double>(cellCount(block)))) + 8;
}

bool areNeighbors(const grid::Block& block, CellId a, CellId b)
{
	bool found = false;
	visitGrid(block,
	          [&](const auto& grid)
	          {
		          for (int f = 0; f < grid.faceCount(a); ++f)
			          grid.forEachNeighbor(a, f, [&](CellId n) { found |= n == b; });
	          });
	return found;
}

} // namespace

TEST(FindCell, FindsTheCellOfAnyPointFromAnyCell)
{
	for (const grid::Block& block : allGrids())
	{
		if (!hasFlatFaces(block))
			continue;
		const BruteForceLocator locator(block);
		std::mt19937 random(90);
		std::uniform_int_distribution<CellId> any_cell(0, static_cast<CellId>(cellCount(block) - 1));
		for (int i = 0; i < 300; ++i)
		{
			const CellId cell = any_cell(random);
			const Vec3 target = pointInside(locator, cell, 0.0, random);
			ASSERT_EQ(locator.cellsHolding(target), std::vector<CellId>{cell}) << block.name;
			for (const CellId start : {any_cell(random), cell, kNoCell})
			{
				const locate::Located located = locate::findCell(block, start, target);
				EXPECT_EQ(located.cell, cell) << block.name << " from " << start;
				EXPECT_LE(located.hops, budget(block));
			}
		}
	}
}

// A point near a warped face may be assigned to the cell across it, but to no other.
TEST(FindCell, ComesToTheCellOrItsNeighborInWarpedGrids)
{
	for (const grid::Block& block : allGrids())
	{
		if (hasFlatFaces(block) || block.name == "three_on_a_face")
			continue;
		const BruteForceLocator locator(block);
		std::mt19937 random(91);
		std::uniform_int_distribution<CellId> any_cell(0, static_cast<CellId>(cellCount(block) - 1));
		int exact = 0;
		constexpr int kTries = 600;
		for (int i = 0; i < kTries; ++i)
		{
			const CellId cell = any_cell(random);
			const Vec3 target = pointInside(locator, cell, 0.5, random);
			const locate::Located located = locate::findCell(block, i % 3 ? any_cell(random) : kNoCell, target);
			ASSERT_TRUE(located.found()) << block.name;
			EXPECT_TRUE(located.cell == cell || areNeighbors(block, located.cell, cell)) << block.name;
			exact += locator.cellHolds(located.cell, target);
			EXPECT_LE(located.hops, budget(block));
		}
		EXPECT_GT(exact, 0.97 * kTries) << block.name;
	}
}

TEST(FindCell, PointsOutsideAreNotFound)
{
	for (const grid::Block& block : allGrids())
	{
		const BruteForceLocator locator(block);
		std::mt19937 random(92);
		std::uniform_int_distribution<CellId> any_cell(0, static_cast<CellId>(cellCount(block) - 1));
		const Box around{block.bounds.lo - 0.2 * block.bounds.size(), block.bounds.hi + 0.2 * block.bounds.size()};
		int outside = 0;
		int mistaken = 0;
		for (int i = 0; i < 600; ++i)
		{
			const Vec3 target = randomPoint(i % 2 ? around : block.bounds, random);
			if (!locator.cellsHolding(target).empty())
				continue;
			++outside;
			const locate::Located located = locate::findCell(block, i % 3 ? any_cell(random) : kNoCell, target);
			mistaken += located.found();
			EXPECT_LE(located.hops, budget(block));
		}
		EXPECT_GT(outside, 50) << block.name;
		// Outside a warped boundary face, but inside the plane that fits it.
		EXPECT_LE(mistaken, hasFlatFaces(block) ? 0 : outside / 25) << block.name;
	}
}

TEST(FindCell, ReportsWhatASearchCosts)
{
	const grid::Block block = explicitHexahedra(20, [](int, int, int) { return true; });
	std::mt19937 random(93);
	for (int i = 0; i < 200; ++i)
	{
		const Vec3 target = randomPoint(block.bounds, random);
		const locate::Located located = locate::findCell(block, kNoCell, target);
		ASSERT_TRUE(located.found());
		EXPECT_LE(located.hops, 60u); // a line crosses at most 3 x 20 cells of a convex domain
		EXPECT_EQ(located.boundary_tests, 0u);
	}
}

// Hops along a duct are many times N^(1/3): the way to its wall is not.
TEST(FindCell, FindsPointsInALongDuct)
{
	grid::Block block;
	const grid::UniformGrid duct({3001, 4, 4}, Vec3(0.0), Vec3(1.0));
	block.grid = duct;
	grid::finishBlock(block);
	std::mt19937 random(94);
	for (int i = 0; i < 200; ++i)
	{
		const Vec3 target = randomPoint(block.bounds, random);
		const locate::Located located = locate::findCell(block, i % 2 ? kNoCell : 0, target);
		const Vec3 index = glm::floor(target);
		EXPECT_EQ(located.cell, duct.cell(static_cast<std::uint32_t>(index.x), static_cast<std::uint32_t>(index.y),
		                                  static_cast<std::uint32_t>(index.z)));
		EXPECT_LE(located.hops, budget(block));
	}
}

TEST(FindCell, AnEmptyBlockHoldsNothing)
{
	grid::Block block;
	block.grid = grid::UniformGrid({5, 5, 1}, Vec3(0.0), Vec3(1.0));
	grid::finishBlock(block);
	EXPECT_FALSE(locate::findCell(block, kNoCell, {1.0, 1.0, 0.0}).found());
}

} // namespace vp::test
