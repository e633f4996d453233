#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "precision_sets.h"
#include "sliced_sheet.h"

#include "classify/gpu_points.h"

#include <random>

namespace vp::test
{

namespace
{

void cutNearWall(gpu::Device& device, const Vec3& offset, bool doubles)
{
	const grid::BlockSet set = build(nearWall(offset));
	classify::GpuBlocksOptions options;
	options.doubles = doubles;
	auto blocks = classify::GpuBlocks::create(device, set, options);
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

// The exported mesh equals the CPU's mesh to the last bit, and almost no cell is left to the CPU.
TEST_F(GpuPrecision, FineCellsFarAwayGiveTheSameMesh)
{
	for (const bool as_hexahedra : {false, true})
	{
		const grid::BlockSet set = build(farAway(as_hexahedra));
		auto blocks = classify::GpuBlocks::create(device(), set, {});
		auto on_gpu = cut::Cutter::onDevice(device(), set, {}, nullptr);
		ASSERT_TRUE(blocks && on_gpu);
		cut::Cutter on_cpu(set);
		std::size_t walked = 0;
		std::size_t cells = 0;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 20, 25))
		{
			const mesh::SheetMesh cpu = cut(on_cpu, plane).mesh;
			const mesh::SheetMesh gpu = cut(**on_gpu, plane).mesh;
			EXPECT_EQ(cpu.positions, gpu.positions);
			EXPECT_EQ(cpu.polygon_vertices, gpu.polygon_vertices);
			EXPECT_EQ(cpu.polygon_starts, gpu.polygon_starts);
			const probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
			const CutBothWays both = cutBothWays(**blocks, std::span(&sheet, 1), {});
			expectSameCells(both);
			expectRecords(set, std::span(&sheet, 1), {}, both);
			walked += both.walked;
			cells += both.cells;
		}
		EXPECT_TRUE(!(*blocks)->usesDoubles() || 50 * walked <= cells) << walked << " of " << cells;
	}
}

TEST(FixedPoints, FlagWhatTheyDoNotHoldExactly)
{
	const Box box{Vec3(-3.0, 1e7, 0.0), Vec3(3.0, 1e7 + 30.0, 1e-3)};
	const classify::FixedPoints fixed(box);
	std::mt19937 random(19);
	const auto unpack = [&](const std::array<std::uint32_t, 4>& packed, int axis)
	{
		const auto low = packed[3] >> (shared::kFixedLowBits * axis) & ((1u << shared::kFixedLowBits) - 1u);
		const double number = static_cast<double>(static_cast<std::int32_t>(packed[axis])) * 512.0 + low;
		return fixed.center()[axis] + number * fixed.unit()[axis];
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
