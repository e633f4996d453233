#include "cut_both_ways.h"
#include "gpu_fixture.h"

#include "slice/gpu_points.h"

#include <random>

namespace vp::test
{

namespace
{

// Layers that start at 1e-6 on a wavy wall and grow to fill 30 units.
grid::BlockSet nearWall(const Vec3& offset)
{
	constexpr std::uint32_t kSide = 9;
	constexpr std::uint32_t kLayers = 60;
	std::vector<double> xyz;
	double height = 0.0;
	double step = 1e-6;
	for (std::uint32_t k = 0; k < kLayers; ++k)
	{
		for (std::uint32_t j = 0; j < kSide; ++j)
			for (std::uint32_t i = 0; i < kSide; ++i)
			{
				const double x = 30.0 * i / (kSide - 1);
				const double y = 30.0 * j / (kSide - 1);
				xyz.insert(xyz.end(), {offset.x + x, offset.y + y, offset.z + 0.1 * std::sin(x + 2 * y) + height});
			}
		height += step;
		step *= 1.3;
	}
	grid::Block block;
	block.name = "near wall";
	block.grid = grid::CurvilinearGrid({kSide, kSide, kLayers}, grid::Points(Array<double>(std::move(xyz))));
	std::vector<double> values(std::size_t(kSide) * kSide * kLayers);
	for (std::size_t i = 0; i < values.size(); ++i)
		values[i] = static_cast<double>(i);
	block.fields.push_back(grid::makeField("number", grid::Association::point, 1, std::move(values)));
	grid::finishBlock(block);
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	return set;
}

void cutNearWall(gpu::Device& device, const Vec3& offset, bool doubles)
{
	const grid::BlockSet set = nearWall(offset);
	slice::GpuBlocksOptions options;
	options.doubles = doubles;
	auto blocks = slice::GpuBlocks::create(device, set, options);
	ASSERT_TRUE(blocks);
	std::mt19937 random(17);
	std::size_t walked = 0;
	std::size_t cells = 0;
	for (int i = 0; i < 40; ++i)
	{
		// Along the wall, within its layers, or across.
		Vec3 normal(0.0, 0.0, 1.0);
		if (i % 2)
			normal = randomDirection(random);
		const Box box = set.blocks[0].bounds;
		Vec3 origin = randomPoint(box, random);
		if (i % 3 == 0)
			origin.z = offset.z + 1e-7 * i;
		const probe::Sheet sheet = probe::makeSheet(origin, normal);
		const CutBothWays cut = cutBothWays(**blocks, std::span(&sheet, 1), {});
		expectSameCells(cut);
		walked += cut.walked;
		cells += cut.cells;
	}
	testing::Test::RecordProperty("walked", static_cast<int>(walked));
	// With doubles next to nothing is left to the CPU.
	EXPECT_TRUE(!(*blocks)->usesDoubles() || 50 * walked <= cells);
	EXPECT_GT(cells, 5000u);
}

} // namespace

using GpuPrecision = GpuTest;

TEST_F(GpuPrecision, NearWallCellsGetTheirSigns)
{
	cutNearWall(device(), Vec3(0.0), true);
}

TEST_F(GpuPrecision, SoFarFromTheOriginToo)
{
	cutNearWall(device(), Vec3(1e7, -1e7, 2e7), true);
}

TEST_F(GpuPrecision, AndWithoutDoubles)
{
	cutNearWall(device(), Vec3(0.0), false);
	cutNearWall(device(), Vec3(1e7, -1e7, 2e7), false);
}

TEST(FixedPoints, FlagWhatTheyDoNotHoldExactly)
{
	const Box box{Vec3(-3.0, 1e7, 0.0), Vec3(3.0, 1e7 + 30.0, 1e-3)};
	const slice::FixedPoints fixed(box);
	std::mt19937 random(19);
	const auto unpack = [&](const std::array<std::uint32_t, 4>& packed, int axis)
	{
		const auto low = packed[3] >> (shared::kFixedLowBits * axis) & ((1u << shared::kFixedLowBits) - 1u);
		const double number = static_cast<double>(static_cast<std::int32_t>(packed[axis])) * 512.0 + low;
		return fixed.centre()[axis] + number * fixed.unit()[axis];
	};
	for (int i = 0; i < 10000; ++i)
	{
		Vec3 p = i == 0 ? box.lo : i == 1 ? box.hi : randomPoint(box, random);
		if (i % 2)
			p = {std::round(p.x * 64.0) / 64.0, std::round(p.y), p.z};
		const auto packed = fixed.pack(p);
		for (int axis = 0; axis < 3; ++axis)
		{
			const double back = unpack(packed, axis);
			const bool inexact = packed[3] >> (shared::kFixedInexactShift + axis) & 1u;
			EXPECT_EQ(inexact, back != p[axis]);
			EXPECT_LE(std::abs(back - p[axis]), 0.5 * fixed.unit()[axis] + 1e-15 * std::abs(p[axis]));
			EXPECT_FALSE(inexact && i % 2 && axis < 2);
		}
	}
	EXPECT_LE(fixed.unit().x, 3.0 * 0x1p-37);
}

} // namespace vp::test
