#include "vprobe-read/convert/octree_parts.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace vp::reader::convert;

namespace
{

std::vector<CellOnCurve> scattered(std::uint32_t count, std::uint32_t most)
{
	std::mt19937 random(7);
	std::uniform_int_distribution<std::uint32_t> along(0, most);
	std::vector<CellOnCurve> cells;
	for (std::uint32_t c = 0; c < count; ++c)
		cells.emplace_back(mortonKey(along(random), along(random), along(random)), c);
	return cells;
}

TEST(OctreeParts, KeysTakeABitOfEachAxisInTurn)
{
	EXPECT_EQ(mortonKey(0, 0, 0), 0u);
	EXPECT_EQ(mortonKey(1, 0, 0), 1u);
	EXPECT_EQ(mortonKey(0, 1, 0), 2u);
	EXPECT_EQ(mortonKey(0, 0, 1), 4u);
	EXPECT_EQ(mortonKey(2, 0, 3), 8u + 4u + 32u);
	EXPECT_EQ(mortonKey(0x1FFFFF, 0x1FFFFF, 0x1FFFFF), 0x7FFFFFFFFFFFFFFFu);
}

TEST(OctreeParts, HoldEveryCellOnceAndAreNotTooLarge)
{
	for (const int threads : {1, 4})
	{
		std::vector<CellOnCurve> cells = scattered(200000, 0x1FFFFF);
		const std::vector<std::size_t> ends = divide(cells, 1000, threads);
		std::set<std::uint32_t> numbers;
		for (const CellOnCurve& cell : cells)
			numbers.insert(cell.second);
		EXPECT_EQ(numbers.size(), 200000u);
		std::size_t begin = 0;
		for (const std::size_t end : ends)
		{
			EXPECT_LT(begin, end);
			EXPECT_LE(end - begin, 1000u);
			begin = end;
		}
		EXPECT_EQ(begin, cells.size());
		// Octants with 390 cells each, or two of them together.
		EXPECT_LE(ends.size(), 400u);
	}
}

TEST(OctreeParts, AreCubesOrSiblings)
{
	std::vector<CellOnCurve> cells = scattered(50000, 0x1FFFFF);
	std::size_t begin = 0;
	for (const std::size_t end : divide(cells, 500, 1))
	{
		// The smallest cube that holds a part has an octant that is larger than parts may be, unless it is the part.
		std::uint64_t low = cells[begin].first, high = cells[end - 1].first;
		int level = 0;
		for (; low >> level != high >> level; level += 3)
		{
		}
		const auto isInCube = [&](const CellOnCurve& cell) { return cell.first >> level == low >> level; };
		const auto in_cube = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), isInCube));
		EXPECT_TRUE(in_cube > 500 || in_cube == end - begin) << begin << " to " << end;
		begin = end;
	}
}

TEST(OctreeParts, CellsInOnePlaceAreCutIntoParts)
{
	std::vector<CellOnCurve> cells(1000, {mortonKey(5, 6, 7), 0});
	EXPECT_EQ(divide(cells, 300, 1), (std::vector<std::size_t>{300, 600, 900, 1000}));
	std::vector<CellOnCurve> none;
	EXPECT_TRUE(divide(none, 300, 1).empty());
	std::vector<CellOnCurve> one(1, {0, 0});
	EXPECT_EQ(divide(one, 300, 1), std::vector<std::size_t>{1});
}

} // namespace
