#include "measure/overlap.h"

#include "sliced_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::measure::test
{

namespace
{

// A lattice of n^3 cells over a cube, as block `input` of one input each.
grid::Block cube(std::uint32_t input, const Vec3& lo, double size, unsigned n)
{
	grid::Block block;
	block.grid = grid::UniformGrid({n + 1, n + 1, n + 1}, lo, Vec3(size / n));
	block.input = input;
	grid::finishBlock(block);
	return block;
}

Overlap overlapIn(std::vector<grid::Block> given, const Vec3& normal)
{
	grid::BlockSet blocks;
	blocks.blocks = std::move(given);
	cut::Cutter cutter(blocks);
	const vp::test::SlicedSheet sheet = vp::test::cut(cutter, {Vec3(0.45), normal});
	return overlapOf(blocks, sheet.mesh, sheet.slice.sheet);
}

} // namespace

TEST(Overlap, IsTheAreaThatTwoInputsShare)
{
	// The second cube is a third finer and moved by 0.25 along x and y: it shares 0.75 x 0.75 with the first.
	const std::vector<grid::Block> blocks{cube(0, Vec3(0.0), 1.0, 6), cube(1, Vec3(0.25, 0.25, 0.0), 1.0, 8)};
	const Overlap flat = overlapIn(blocks, Vec3(0.0, 0.0, 1.0));
	EXPECT_NEAR(flat.area, 0.5625, 1e-12);
	EXPECT_NEAR(flat.share, 0.5625 / 2.0, 1e-12);
	EXPECT_EQ(flat.inputs, (std::pair<std::uint32_t, std::uint32_t>{0, 1}));
	// Through z along the diagonal x = y, seen as a rectangle of 0.75 sqrt(2) by 1.
	EXPECT_NEAR(overlapIn(blocks, Vec3(1.0, -1.0, 0.0)).area, 0.75 * std::sqrt(2.0), 1e-12);
	// Three in one place are three pairs.
	EXPECT_NEAR(overlapIn({cube(0, Vec3(0.0), 1.0, 3), cube(1, Vec3(0.0), 1.0, 4), cube(2, Vec3(0.0), 1.0, 5)},
	                      Vec3(0.0, 0.0, 1.0))
	                .area,
	            3.0, 1e-12);
}

TEST(Overlap, InputsThatTouchAndBlocksOfOneInputDoNotOverlap)
{
	EXPECT_EQ(overlapIn({cube(0, Vec3(0.0), 1.0, 4), cube(1, Vec3(1.0, 0.0, 0.0), 1.0, 4)}, Vec3(0.3, 0.5, 0.8)).area,
	          0.0);
	EXPECT_EQ(overlapIn({cube(0, Vec3(0.0), 1.0, 4), cube(0, Vec3(0.0), 1.0, 8)}, Vec3(0.3, 0.5, 0.8)), Overlap());
	// Bounds that meet are not enough.
	EXPECT_EQ(overlapIn({cube(0, Vec3(0.0), 1.0, 4), cube(1, Vec3(0.2, 0.2, 5.0), 1.0, 4)}, Vec3(0.0, 0.0, 1.0)).area,
	          0.0);
}

} // namespace vp::measure::test
