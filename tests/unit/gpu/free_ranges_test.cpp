#include "gpu/free_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace vp::gpu
{

TEST(FreeRanges, TakesTheSmallestRangeWithRoom)
{
	FreeRanges ranges(1000);
	const auto first = ranges.take(100, 1);
	const auto second = ranges.take(50, 1);
	const auto third = ranges.take(100, 1);
	ASSERT_TRUE(first && second && third);
	ranges.give(*first, 100);
	ranges.give(*third, 100); // now touches the rest
	EXPECT_EQ(ranges.take(80, 1), *first);
	EXPECT_EQ(ranges.free(), 1000u - 50u - 80u);
	EXPECT_FALSE(ranges.take(851, 1)); // 870 are free, but not in one range
	EXPECT_EQ(ranges.take(850, 1), 150u);
}

TEST(FreeRanges, BeginsAtMultiplesOfTheAlignment)
{
	FreeRanges ranges(256);
	EXPECT_EQ(ranges.take(1, 1), 0u);
	EXPECT_EQ(ranges.take(64, 64), 64u);
	EXPECT_EQ(ranges.take(128, 128), 128u);
	EXPECT_FALSE(ranges.take(64, 64)); // 63 bytes are left, from 1 on
	EXPECT_EQ(ranges.take(60, 4), 4u);
}

// A byte for every byte of the page says whose it is.
TEST(FreeRanges, NoTwoPiecesShareAByteAndAllComeTogetherAgain)
{
	struct Piece
	{
		std::uint64_t begin;
		std::uint64_t bytes;
	};
	constexpr std::uint64_t kBytes = 4096;
	std::mt19937 random(7);
	for (int round = 0; round < 20; ++round)
	{
		FreeRanges ranges(kBytes);
		std::vector<bool> taken(kBytes, false);
		std::vector<Piece> pieces;
		for (int step = 0; step < 500; ++step)
		{
			const bool takes = pieces.empty() || random() % 5 < 3;
			if (takes)
			{
				const std::uint64_t bytes = 1 + random() % 300;
				const std::uint64_t alignment = std::uint64_t(1) << random() % 8;
				const auto begin = ranges.take(bytes, alignment);
				if (!begin)
					continue;
				ASSERT_EQ(*begin % alignment, 0u);
				ASSERT_LE(*begin + bytes, kBytes);
				for (std::uint64_t i = *begin; i < *begin + bytes; ++i)
				{
					ASSERT_FALSE(taken[i]);
					taken[i] = true;
				}
				pieces.push_back({*begin, bytes});
			}
			else
			{
				const std::size_t which = random() % pieces.size();
				const Piece piece = pieces[which];
				pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(which));
				ranges.give(piece.begin, piece.bytes);
				for (std::uint64_t i = piece.begin; i < piece.begin + piece.bytes; ++i)
					taken[i] = false;
			}
			ASSERT_EQ(ranges.free(), static_cast<std::uint64_t>(std::count(taken.begin(), taken.end(), false)));
		}
		for (const Piece& piece : pieces)
			ranges.give(piece.begin, piece.bytes);
		EXPECT_TRUE(ranges.allFree());
		EXPECT_EQ(ranges.take(kBytes, 1), 0u);
	}
}

} // namespace vp::gpu
