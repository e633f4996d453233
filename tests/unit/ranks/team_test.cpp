#include "ranks/data/share.h"
#include "ranks/picture/merged_layers.h"
#include "ranks/team.h"
#include "shared/slice_types.h"
#include "thread_team.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

using namespace vp;
using namespace vp::ranks;

namespace
{

Bytes bytesOf(const std::string& text)
{
	MessageWriter message;
	message.put(text);
	return message.take();
}

std::string textOf(const Bytes& bytes)
{
	return MessageReader(bytes).getText();
}

std::vector<read::Part> partsOf(const std::vector<std::size_t>& cells)
{
	std::vector<read::Part> parts;
	for (const std::size_t count : cells)
		parts.push_back({.cells = count});
	return parts;
}

} // namespace

TEST(Team, GathersInTheOrderOfRanks)
{
	for (int ranks = 1; ranks <= 9; ++ranks)
		withTeam(ranks,
		         [&](Team& team)
		         {
			         const std::vector<Bytes> all =
			             team.gatherAll(bytesOf(std::string(static_cast<std::size_t>(team.rank()), 'a')));
			         ASSERT_EQ(all.size(), static_cast<std::size_t>(ranks));
			         for (std::size_t rank = 0; rank < all.size(); ++rank)
				         EXPECT_EQ(textOf(all[rank]), std::string(rank, 'a')) << ranks;
		         });
}

TEST(Team, GivesAllWhatTheFirstHas)
{
	for (int ranks = 1; ranks <= 9; ++ranks)
		withTeam(ranks,
		         [&](Team& team)
		         {
			         Bytes bytes = team.isFirst() ? bytesOf("news") : Bytes();
			         team.broadcast(bytes);
			         EXPECT_EQ(textOf(bytes), "news") << ranks;
		         });
}

TEST(Team, ExchangesWithEach)
{
	for (int ranks = 1; ranks <= 6; ++ranks)
		withTeam(ranks,
		         [&](Team& team)
		         {
			         std::vector<Bytes> to;
			         for (int rank = 0; rank < ranks; ++rank)
				         to.push_back(bytesOf(std::to_string(team.rank()) + " to " + std::to_string(rank)));
			         const std::vector<Bytes> from = team.exchange(to);
			         for (int rank = 0; rank < ranks; ++rank)
				         EXPECT_EQ(textOf(from[static_cast<std::size_t>(rank)]),
				                   std::to_string(rank) + " to " + std::to_string(team.rank()));
		         });
}

TEST(Team, SumsOverAll)
{
	withTeam(7,
	         [](Team& team)
	         {
		         int sum = team.rank() + 1;
		         sumOverAll(team, sum, [](int& into, int other) { into += other; });
		         EXPECT_EQ(sum, 28);
		         EXPECT_TRUE(anyOf(team, team.rank() == 4));
		         EXPECT_FALSE(anyOf(team, false));
	         });
}

TEST(DealOut, KeepsPartsTogetherAndBalanced)
{
	EXPECT_EQ(dealOut(partsOf({10, 10, 10, 10}), 2), (std::vector<int>{0, 0, 1, 1}));
	EXPECT_EQ(dealOut(partsOf({100, 1, 1, 1}), 4), (std::vector<int>{0, 1, 1, 1}));
	EXPECT_EQ(dealOut(partsOf({5, 5}), 8), (std::vector<int>{0, 1}));
	EXPECT_EQ(dealOut(partsOf({5}), 3), std::vector<int>{0});
	EXPECT_EQ(dealOut(partsOf({0, 0, 0}), 2).size(), 3u);
	EXPECT_TRUE(dealOut({}, 4).empty());
}

TEST(DealOut, GivesNoRankMoreThanNeedsBe)
{
	std::vector<std::size_t> cells;
	for (std::size_t i = 0; i < 40; ++i)
		cells.push_back(1 + i * 7919 % 1000);
	for (const int ranks : {1, 2, 3, 8, 40, 100})
	{
		const std::vector<int> dealt = dealOut(partsOf(cells), ranks);
		ASSERT_TRUE(std::ranges::is_sorted(dealt));
		EXPECT_LT(dealt.back(), ranks);
		std::vector<std::size_t> load(static_cast<std::size_t>(ranks));
		for (std::size_t p = 0; p < cells.size(); ++p)
			load[static_cast<std::size_t>(dealt[p])] += cells[p];
		const std::size_t all = std::accumulate(cells.begin(), cells.end(), std::size_t(0));
		const std::size_t largest = std::ranges::max(cells);
		EXPECT_LE(std::ranges::max(load), all / static_cast<std::size_t>(ranks) + largest) << ranks;
	}
}

TEST(MergedLayers, TakeTheHighestRankThatHasAValue)
{
	constexpr float none = shared::kEmptyValue;
	constexpr float nan = shared::kNanValue;
	// Two layers of 3 x 1 pixels, of each rank.
	const std::vector<std::vector<float>> of_rank = {{1.0f, 1.0f, 1.0f, none, none, 1.0f},
	                                                 {none, 2.0f, none, 2.0f, none, 2.0f},
	                                                 {none, none, 3.0f, none, none, nan}};
	withTeam(3,
	         [&](Team& team)
	         {
		         std::vector<float> values = of_rank[static_cast<std::size_t>(team.rank())];
		         std::uint64_t sent = 0;
		         const bool goes_on = mergeLayers(team, {3, 1, 2, 1, values}, sent);
		         EXPECT_EQ(goes_on, team.isFirst());
		         EXPECT_EQ(sent > 0, !team.isFirst());
		         if (team.isFirst())
		         {
			         EXPECT_EQ(values, (std::vector<float>{1.0f, 2.0f, 3.0f, 2.0f, none, nan}));
		         }
	         });
}

TEST(MergedLayers, TakeAllChannelsFromOneRank)
{
	constexpr float none = shared::kEmptyValue;
	withTeam(2,
	         [&](Team& team)
	         {
		         std::vector<float> values = team.isFirst() ? std::vector<float>{1.0f, 0.5f, 1.0f, 0.25f}
		                                                    : std::vector<float>{2.0f, 0.0f, none, 1.0f};
		         std::uint64_t sent = 0;
		         if (mergeLayers(team, {2, 1, 1, 2, values}, sent))
		         {
			         EXPECT_EQ(values, (std::vector<float>{2.0f, 0.0f, 1.0f, 0.25f}));
		         }
	         });
}
