#include "vprobe-read/convert/curve_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace vp::reader::convert
{

namespace
{

// Sorts cells at these places, and returns their numbers.
std::vector<std::uint32_t> sorted(const std::vector<std::uint64_t>& at, int threads)
{
	const auto tell = [&](std::size_t first, std::span<std::uint64_t> places)
	{ std::copy_n(at.begin() + static_cast<std::ptrdiff_t>(first), places.size(), places.begin()); };
	std::vector<std::uint32_t> cells;
	for (const CellOnCurve& cell : alongCurve(at.size(), tell, threads))
	{
		EXPECT_EQ(cell.place, at[cell.cell]);
		cells.push_back(cell.cell);
	}
	return cells;
}

} // namespace

TEST(CurveOrder, PlacesHaveABitOfEachAxisInTurn)
{
	EXPECT_EQ(mortonKey(0, 0, 0), 0u);
	EXPECT_EQ(mortonKey(1, 0, 0), 1u);
	EXPECT_EQ(mortonKey(0, 1, 0), 2u);
	EXPECT_EQ(mortonKey(0, 0, 1), 4u);
	EXPECT_EQ(mortonKey(2, 0, 3), 8u + 4u + 32u);
	EXPECT_EQ(mortonKey(0x1FFFFF, 0x1FFFFF, 0x1FFFFF), 0x7FFFFFFFFFFFFFFFu);
}

TEST(CurveOrder, SortsByPlaceAndThenByNumber)
{
	std::mt19937_64 random(7);
	for (const int threads : {1, 4})
		for (const std::size_t cells : {0, 1, 2, 1000, 65536, 300000})
			for (const std::uint64_t different : {std::uint64_t(3), kBehindTheCurve})
			{
				std::vector<std::uint64_t> at(cells);
				for (std::uint64_t& place : at)
					place = random() % 10 == 0 ? kBehindTheCurve : random() % different * (kBehindTheCurve / different);
				std::vector<std::uint32_t> wanted(cells);
				for (std::size_t c = 0; c < cells; ++c)
					wanted[c] = static_cast<std::uint32_t>(c);
				std::stable_sort(wanted.begin(), wanted.end(),
				                 [&](std::uint32_t a, std::uint32_t b) { return at[a] < at[b]; });
				EXPECT_EQ(sorted(at, threads), wanted) << cells << " cells, " << threads << " threads";
			}
}

} // namespace vp::reader::convert
