#include "launched.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace vp::test
{

using vectors::LatticeChoice;
using vectors::Launch;
using vectors::SheetLattice;

namespace
{

struct Cut
{
	mesh::SheetMesh mesh;
	probe::Sheet sheet;
};

Cut cutOf(const grid::BlockSet& blocks, const Vec3& origin, std::optional<probe::Window> window)
{
	cut::Cutter cutter(blocks);
	const SlicedSheet sheet = cut(cutter, {origin, {0.0, 0.0, 1.0}}, {}, Search::fastest, window);
	return {sheet.mesh, sheet.slice.sheet};
}

} // namespace

TEST(Lattice, FillsTheWindowEvenly)
{
	const grid::BlockSet blocks = demo("blob", 8);
	const Cut cut = cutOf(blocks, {0.0, 0.0, 0.2}, probe::centeredWindow(2.0, 1.0));
	const SheetLattice lattice = vectors::launchLattice(cut.mesh, cut.sheet, {10, 0.0});
	EXPECT_DOUBLE_EQ(lattice.spacing, 0.2);
	ASSERT_EQ(lattice.launches.size(), 50u);
	EXPECT_LT(glm::length(lattice.launches.front().position - Vec3(-0.9, -0.4, 0.2)), 1e-12);
	EXPECT_LT(glm::length(lattice.launches.back().position - Vec3(0.9, 0.4, 0.2)), 1e-12);
}

TEST(Lattice, WithoutAWindowItFillsTheBoundsOfTheCut)
{
	const grid::BlockSet blocks = demo("blob", 8);
	const Cut cut = cutOf(blocks, {0.3, 0.1, 0.2}, {});
	const SheetLattice lattice = vectors::launchLattice(cut.mesh, cut.sheet, {12, 0.0});
	EXPECT_NEAR(lattice.spacing, 0.5, 1e-12);
	EXPECT_EQ(lattice.launches.size(), 144u);
}

// The cut of the shell is half a ring: places beside it have no launch, and others keep their numbers.
TEST(Lattice, OnlyWhatIsCutAndInTheCellThatIsTold)
{
	for (const grid::Demo& kind : grid::demos())
	{
		const grid::BlockSet blocks = demo(kind.name, 9);
		const Cut cut = cutOf(blocks, {0.0, 0.0, 0.35}, probe::centeredWindow(7.0, 7.0));
		const SheetLattice lattice = vectors::launchLattice(cut.mesh, cut.sheet, {30, 1.0});
		const bool thin = std::string_view(kind.name) == "layer"; // which meets few of the lattice's places
		EXPECT_GT(lattice.launches.size(), thin ? 10u : 200u) << kind.name;
		EXPECT_LT(lattice.launches.size(), 900u) << kind.name;
		std::set<std::uint32_t> seeds;
		for (const Launch& launch : lattice.launches)
		{
			EXPECT_TRUE(seeds.insert(launch.seed).second);
			EXPECT_LT(launch.seed, 900u);
			EXPECT_NEAR(launch.position.z, 0.35, 1e-12);
			locate::CellWeights weights;
			locate::weighCell(blocks.blocks[launch.block], launch.cell, launch.position, weights);
			EXPECT_GT(weights.depth, -0.05) << kind.name; // a warped cell's section is flat
		}
	}
}

TEST(Lattice, JitterFollowsFromThePlaceAlone)
{
	const grid::BlockSet blocks = demo("blob", 8);
	const auto at = [&](double z, double jitter)
	{
		const Cut cut = cutOf(blocks, {0.0, 0.0, z}, probe::centeredWindow(3.0, 3.0));
		return vectors::launchLattice(cut.mesh, cut.sheet, {10, jitter}).launches;
	};
	const auto regular = at(0.1, 0.0);
	const auto moved = at(0.1, 1.0);
	const auto half = at(0.1, 0.5);
	const auto elsewhere = at(0.7, 1.0);
	ASSERT_EQ(moved.size(), 100u);
	double most = 0.0;
	for (std::size_t i = 0; i < moved.size(); ++i)
	{
		const Vec3 off = moved[i].position - regular[i].position;
		EXPECT_LE(std::max(std::abs(off.x), std::abs(off.y)), 0.15);
		most = std::max(most, glm::length(off));
		EXPECT_LT(glm::length(0.5 * off - (half[i].position - regular[i].position)), 1e-12);
		EXPECT_LT(glm::length(elsewhere[i].position - moved[i].position - Vec3(0.0, 0.0, 0.6)), 1e-12);
	}
	EXPECT_GT(most, 0.1);
}

TEST(Lattice, NothingCutGivesNothing)
{
	const grid::BlockSet blocks = demo("blob", 4);
	const Cut cut = cutOf(blocks, {0.0, 0.0, 50.0}, {});
	EXPECT_TRUE(vectors::launchLattice(cut.mesh, cut.sheet, {}).launches.empty());
}

} // namespace vp::test
