#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "test_grids.h"
#include "uploaded.h"

#include "gpu/upload.h"

#include <cstring>

namespace vp::test
{

namespace
{

// Buffers to upload to and read back, of sizes around the arena's granules.
std::vector<gpu::Buffer> filledBuffers(gpu::Device& device, std::size_t count, gpu::Memory memory)
{
	std::vector<gpu::Buffer> buffers;
	for (std::size_t i = 0; i < count; ++i)
	{
		auto made =
		    gpu::Buffer::create(device, 4 * (1 + i * 37 % 4000),
		                        VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT, memory, "piece");
		EXPECT_TRUE(made);
		const std::vector<std::uint32_t> values(made->size() / 4, static_cast<std::uint32_t>(i));
		EXPECT_TRUE(gpu::upload(*made, std::as_bytes(std::span(values))));
		buffers.push_back(std::move(*made));
	}
	return buffers;
}

void expectStillFilled(const std::vector<gpu::Buffer>& buffers)
{
	for (std::size_t i = 0; i < buffers.size(); ++i)
	{
		std::vector<std::uint32_t> values(buffers[i].size() / 4);
		ASSERT_TRUE(gpu::download(buffers[i], 0, std::as_writable_bytes(std::span(values))));
		const std::vector<std::uint32_t> expected(values.size(), static_cast<std::uint32_t>(i));
		ASSERT_EQ(values, expected) << "buffer " << i;
	}
}

} // namespace

TEST_F(GpuTest, BuffersShareFewAllocations)
{
	const std::size_t before = device().memoryUse().pages;
	const std::vector<gpu::Buffer> buffers = filledBuffers(device(), 1500, gpu::Memory::device);
	expectStillFilled(buffers);
	EXPECT_LE(device().memoryUse().pages, before + 2);
	EXPECT_GE(device().memoryUse().used, 1500u * 4u);
}

TEST_F(StagedGpuTest, BuffersShareFewAllocations)
{
	const std::vector<gpu::Buffer> buffers = filledBuffers(device(), 150, gpu::Memory::device);
	for (const gpu::Buffer& buffer : buffers)
		EXPECT_EQ(buffer.mapped(), nullptr);
	expectStillFilled(buffers);
}

TEST_F(GpuTest, EveryKindOfMemoryHoldsItsOwn)
{
	const std::vector<gpu::Buffer> up = filledBuffers(device(), 50, gpu::Memory::upload);
	const std::vector<gpu::Buffer> back = filledBuffers(device(), 50, gpu::Memory::readback);
	expectStillFilled(up);
	expectStillFilled(back);
}

TEST_F(GpuTest, MemoryIsGivenBack)
{
	constexpr VkDeviceSize kLarge = VkDeviceSize(200) << 20; // a page of its own
	const auto take = [&](VkDeviceSize bytes)
	{ return gpu::Buffer::create(device(), bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::Memory::device, "taken"); };
	const gpu::MemoryUse before = device().memoryUse();
	{
		const auto large = take(kLarge);
		if (!large)
			GTEST_SKIP() << "the device lacks memory for this";
		EXPECT_GE(device().memoryUse().reserved, before.reserved + kLarge);
	}
	EXPECT_EQ(device().memoryUse().reserved, before.reserved);
	EXPECT_EQ(device().memoryUse().used, before.used);

	const auto small = [&] { return take(1000).value().size(); };
	EXPECT_GE(small(), 1000u);
	const gpu::MemoryUse once = device().memoryUse();
	for (int i = 0; i < 100; ++i)
		small();
	EXPECT_EQ(device().memoryUse().reserved, once.reserved);
	EXPECT_EQ(device().memoryUse().used, once.used);
}

// Most drivers allow 4096 allocations; the driver under test may allow any number.
TEST_F(GpuTest, FiveThousandBlocksNeedFewAllocations)
{
	constexpr std::size_t kBlocks = 5000;
	grid::BlockSet set;
	for (std::size_t i = 0; i < kBlocks; ++i)
		set.blocks.push_back(gridNamed("u_shape"));
	const auto blocks = upload(device(), set);
	EXPECT_EQ(blocks->heldCount(), kBlocks);
	EXPECT_LE(device().memoryUse().pages, 64u);

	const std::vector<probe::Sheet> sheets{
	    probe::makeSheet(set.blocks[0].bounds.center(), Vec3{0.3, 0.5, 0.8}, {0.3, 1.0, 0.2})};
	const CutBothWays cut = cutBothWays(*blocks, sheets, std::nullopt);
	EXPECT_GT(cut.cells, kBlocks);
	expectSameCells(cut);
	EXPECT_LT(device().memoryUse().pages, 4096u / 16u);
}

TEST_F(GpuTest, TenDataSetsLeaveNoMoreMemoryThanOne)
{
	gpu::MemoryUse once;
	for (int round = 0; round < 10; ++round)
	{
		grid::BlockSet set;
		set.blocks.push_back(gridNamed("hexes"));
		{
			const auto blocks = upload(device(), set);
			const std::vector<probe::Sheet> sheets{
			    probe::makeSheet(set.blocks[0].bounds.center(), Vec3{0.3, 0.5, 0.8}, {0.3, 1.0, 0.2})};
			expectSameCells(cutBothWays(*blocks, sheets, std::nullopt));
		}
		ASSERT_TRUE(device().waitIdle());
		if (round == 0)
			once = device().memoryUse();
	}
	EXPECT_EQ(device().memoryUse().used, once.used);
	EXPECT_EQ(device().memoryUse().reserved, once.reserved);
	EXPECT_EQ(device().memoryUse().pages, once.pages);
}

} // namespace vp::test
