#include "vprobe-read/convert/octree_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace vp::reader::convert;

namespace
{

std::vector<CellOnCurve> scattered(std::uint32_t count)
{
	std::mt19937 random(7);
	std::uniform_int_distribution<std::uint32_t> along(0, 0x1FFFFF);
	std::vector<CellOnCurve> cells;
	for (std::uint32_t c = 0; c < count; ++c)
		cells.push_back({mortonKey(along(random), along(random), along(random)), c});
	std::ranges::sort(cells, {}, &CellOnCurve::place);
	return cells;
}

} // namespace

TEST(OctreeParts, HoldEveryCellAndAreNotTooLarge)
{
	const std::vector<CellOnCurve> cells = scattered(200000);
	const std::vector<std::size_t> ends = divide(cells, 1000);
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

TEST(OctreeParts, AreCubesOrSiblings)
{
	const std::vector<CellOnCurve> cells = scattered(50000);
	std::size_t begin = 0;
	for (const std::size_t end : divide(cells, 500))
	{
		// The smallest cube that holds a part has an octant that is larger than parts may be, unless it is the part.
		std::uint64_t low = cells[begin].place, high = cells[end - 1].place;
		int level = 0;
		for (; low >> level != high >> level; level += 3)
		{
		}
		const auto isInCube = [&](const CellOnCurve& cell) { return cell.place >> level == low >> level; };
		const auto in_cube = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), isInCube));
		EXPECT_TRUE(in_cube > 500 || in_cube == end - begin) << begin << " to " << end;
		begin = end;
	}
}

TEST(OctreeParts, CellsInOnePlaceAreCutIntoParts)
{
	const std::vector<CellOnCurve> cells(1000, {mortonKey(5, 6, 7), 0});
	EXPECT_EQ(divide(cells, 300), (std::vector<std::size_t>{300, 600, 900, 1000}));
	EXPECT_TRUE(divide({}, 300).empty());
	const std::vector<CellOnCurve> one(1, {0, 0});
	EXPECT_EQ(divide(one, 300), std::vector<std::size_t>{1});
}
