#include "ranks/neighborhood.h"
#include "ranks/picture/merged_layers.h"
#include "thread_team.h"

#include <gtest/gtest.h>

namespace vp::ranks
{

namespace
{

// Unit cubes along x, one for each rank.
std::vector<Box> cubes(int ranks)
{
	std::vector<Box> boxes;
	for (int rank = 0; rank < ranks; ++rank)
		boxes.push_back({{double(rank), 0.0, 0.0}, {rank + 1.0, 1.0, 1.0}});
	return boxes;
}

} // namespace

TEST(Neighborhood, TalksToRanksBesideItAlone)
{
	withTeam(5,
	         [](Team& team)
	         {
		         Neighborhood near(team, cubes(5), 0.0);
		         for (const int other : near.ranks())
			         EXPECT_EQ(std::abs(other - team.rank()), 1);
		         for (const int other : near.ranks())
			         near.messageFor(other).put(team.rank());
		         const std::vector<Bytes> came = near.exchange();
		         for (int rank = 0; rank < 5; ++rank)
		         {
			         const Bytes& bytes = came[static_cast<std::size_t>(rank)];
			         ASSERT_EQ(bytes.empty(), std::abs(rank - team.rank()) != 1);
			         if (!bytes.empty())
			         {
				         EXPECT_EQ(MessageReader(bytes).get<int>(), rank);
			         }
		         }
		         Neighborhood wide(team, cubes(5), 1.0);
		         EXPECT_EQ(wide.ranks().size(), team.rank() == 2 ? 4u : team.rank() % 2 == 1 ? 4u : 3u);
	         });
}

TEST(Neighborhood, AllThatHoldAPlaceAgreeOnItsOwner)
{
	withTeam(4,
	         [](Team& team)
	         {
		         const Neighborhood near(team, cubes(4), 0.0);
		         for (int border = 1; border < 4; ++border)
			         if (team.rank() == border - 1 || team.rank() == border)
			         {
				         EXPECT_EQ(near.ownerOf({double(border), 0.5, 0.5}), border - 1);
			         }
		         EXPECT_EQ(near.ownerOf({team.rank() + 0.5, 0.5, 0.5}), team.rank());
	         });
}

TEST(Neighborhood, RanksWithoutCellsTakeNoPart)
{
	std::vector<Box> boxes = cubes(2);
	boxes.emplace_back();
	withTeam(3,
	         [&](Team& team)
	         {
		         Neighborhood near(team, boxes, 0.5);
		         EXPECT_EQ(near.ranks().size(), team.rank() == 2 ? 0u : 1u);
		         for (const Bytes& bytes : near.exchange())
			         EXPECT_TRUE(bytes.empty());
	         });
}

TEST(MergedLayers, TakeTheNearestOpaqueFragmentAndAllOthers)
{
	using Pixels = std::vector<render::SurfacePixel>;
	// Pixel, depth, color, surface. At pixel 2 the lower surface, and then the lower rank, is drawn first.
	const std::vector<Pixels> nearest = {{{0, 0.5f, 10, 0}, {2, 0.5f, 11, 1}},
	                                     {{0, 0.7f, 20, 0}, {1, 0.1f, 21, 0}, {2, 0.5f, 22, 0}},
	                                     {{2, 0.5f, 30, 0}, {3, 0.2f, 31, 1}}};
	withTeam(3,
	         [&](Team& team)
	         {
		         const auto rank = static_cast<std::uint32_t>(team.rank());
		         render::SurfaceFragments surfaces{nearest[rank], {{rank, 0.5f, rank, 0}, {7, 0.5f, rank, 0}}};
		         std::uint64_t sent = 0;
		         const render::LayerValues layers{4, 2, 0, 1, {}, &surfaces};
		         if (!mergeLayers(team, layers, sent))
			         return;
		         EXPECT_EQ(surfaces.nearest,
		                   (Pixels{{0, 0.7f, 20, 0}, {1, 0.1f, 21, 0}, {2, 0.5f, 22, 0}, {3, 0.2f, 31, 1}}));
		         EXPECT_EQ(surfaces.listed.size(), 6u);
	         });
}

} // namespace vp::ranks
