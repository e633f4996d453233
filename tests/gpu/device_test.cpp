#include "gpu_fixture.h"

#include "base/timeline.h"
#include "gpu/commands.h"
#include "gpu/compile_shader.h"
#include "gpu/invocations.h"
#include "gpu/shader.h"
#include "gpu/timers.h"
#include "gpu/upload.h"

#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>
#include <thread>

namespace vp::test
{

namespace
{

std::vector<std::uint32_t> numbers(std::size_t count)
{
	std::vector<std::uint32_t> values(count);
	std::iota(values.begin(), values.end(), 7u);
	return values;
}

} // namespace

TEST_F(GpuTest, TellsItsName)
{
	EXPECT_FALSE(device().name().empty());
	EXPECT_GT(device().memoryLeft(), 0u);
}

// If the loader left the layer out, tests on restricted devices would show nothing.
TEST_F(GpuTest, RestrictionsAreThere)
{
	const char* set = std::getenv("VPROBE_LAYER_RESTRICT");
	const std::string restrictions = set ? set : "";
	if (restrictions.find("small-texels") != std::string::npos)
	{
		EXPECT_EQ(device().limits().maxTexelBufferElements, 65536u);
	}
	if (restrictions.find("few-descriptors") != std::string::npos)
	{
		EXPECT_EQ(device().limits().maxPerStageDescriptorStorageBuffers, 4u);
	}
	if (restrictions.find("no-float64") != std::string::npos)
	{
		EXPECT_FALSE(device().hasExactDoubles());
	}
}

TEST_F(GpuTest, UnknownNameListsWhatThereIs)
{
	gpu::DeviceOptions options;
	options.name_or_index = "no such device";
	const auto made = gpu::Device::create(options);
	ASSERT_FALSE(made);
	EXPECT_EQ(made.error().kind, ErrorKind::device);
	EXPECT_NE(made.error().message.find(device().name()), std::string::npos) << made.error().message;
	options.name_or_index = "999";
	EXPECT_FALSE(gpu::Device::create(options));
}

TEST_F(GpuTest, IsFoundByIndexAndByPartOfItsName)
{
	gpu::DeviceOptions options;
	options.name_or_index = "0";
	EXPECT_TRUE(gpu::Device::create(options));
	options.name_or_index = device().name().substr(1, 5);
	for (char& c : options.name_or_index)
		c = static_cast<char>(std::toupper(c));
	EXPECT_TRUE(gpu::Device::create(options));
}

TEST_F(GpuTest, BufferReadsBackWhatWasUploaded)
{
	const auto values = numbers(100000);
	auto buffer =
	    gpu::uploaded(device(), std::as_bytes(std::span(values)), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "numbers");
	ASSERT_TRUE(buffer);
	std::vector<std::uint32_t> back(values.size());
	ASSERT_TRUE(gpu::download(*buffer, 0, std::as_writable_bytes(std::span(back))));
	EXPECT_EQ(back, values);
}

TEST_F(StagedGpuTest, UploadsInSeveralRuns)
{
	// More than one staging buffer holds.
	const auto values = numbers(std::size_t(20) << 20);
	auto buffer =
	    gpu::uploaded(device(), std::as_bytes(std::span(values)), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "numbers");
	ASSERT_TRUE(buffer);
	EXPECT_EQ(buffer->mapped(), nullptr);
	std::vector<std::uint32_t> back(values.size());
	ASSERT_TRUE(gpu::download(*buffer, 0, std::as_writable_bytes(std::span(back))));
	EXPECT_EQ(back, values);
}

TEST_F(GpuTest, BuffersMoveAndMayDieWhileInUse)
{
	const auto values = numbers(1000);
	auto target =
	    gpu::Buffer::create(device(), 4000, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::readback, "target");
	ASSERT_TRUE(target);
	gpu::Buffer moved = std::move(*target);
	EXPECT_FALSE(*target);
	auto commands = gpu::Commands::create(device(), "copy");
	ASSERT_TRUE(commands);
	auto recording = commands->begin();
	ASSERT_TRUE(recording);
	{
		auto source =
		    gpu::uploaded(device(), std::as_bytes(std::span(values)), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "source");
		ASSERT_TRUE(source);
		const VkBufferCopy region{0, 0, 4000};
		vkCmdCopyBuffer(*recording, source->handle(), moved.handle(), 1, &region);
		gpu::memoryBarrier(*recording, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
		                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
		ASSERT_TRUE(commands->submit());
	}
	ASSERT_TRUE(commands->wait());
	moved.invalidate();
	EXPECT_EQ(std::memcmp(moved.mapped(), values.data(), 4000), 0);
}

TEST_F(GpuTest, BufferPastTheLimitIsAnError)
{
	const auto made = gpu::Buffer::create(device(), ~VkDeviceSize(0) / 2, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
	                                      gpu::Memory::device, "too large");
	ASSERT_FALSE(made);
	EXPECT_EQ(made.error().kind, ErrorKind::out_of_memory);
}

TEST_F(UnvalidatedGpuTest, ThreadsShareTheQueue)
{
	std::vector<std::thread> threads;
	std::atomic<int> done = 0;
	for (int t = 0; t < 4; ++t)
		threads.emplace_back(
		    [&]
		    {
			    const auto values = numbers(5000 + t);
			    for (int i = 0; i < 20; ++i)
			    {
				    auto buffer = gpu::uploaded(device(), std::as_bytes(std::span(values)),
				                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "numbers");
				    auto copy = gpu::Buffer::create(device(), 4 * values.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
				                                    gpu::Memory::readback, "copy");
				    if (!buffer || !copy)
					    return;
				    const Status copied =
				        gpu::runOnce(device(), "copy",
				                     [&](VkCommandBuffer commands)
				                     {
					                     const VkBufferCopy region{0, 0, 4 * values.size()};
					                     vkCmdCopyBuffer(commands, buffer->handle(), copy->handle(), 1, &region);
				                     });
				    copy->invalidate();
				    if (!copied || std::memcmp(copy->mapped(), values.data(), 4 * values.size()) != 0)
					    return;
			    }
			    ++done;
		    });
	for (std::thread& thread : threads)
		thread.join();
	EXPECT_EQ(done, 4);
}

TEST_F(GpuTest, TimesPassesOnTheTimelinesClock)
{
	if (device().timestampBits() == 0)
		GTEST_SKIP() << device().name() << " has no timestamps";
	Timeline timeline(Timeline::Keep::sections);
	gpu::Timers timers(device());
	auto buffer =
	    gpu::Buffer::create(device(), 1 << 20, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::device, "filled");
	ASSERT_TRUE(buffer);
	const double begin = timeline.now();
	constexpr int kPasses = 600; // more than one pool of queries holds
	for (int i = 0; i < kPasses; ++i)
		ASSERT_TRUE(gpu::runOnce(device(), "fill",
		                         [&](VkCommandBuffer commands)
		                         {
			                         const gpu::TimedPass pass(timers, commands, "fill");
			                         vkCmdFillBuffer(commands, buffer->handle(), 0, VK_WHOLE_SIZE, 1);
			                         gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_CLEAR_BIT,
			                                            VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_CLEAR_BIT,
			                                            VK_ACCESS_2_TRANSFER_WRITE_BIT);
		                         }));
	const double end = timeline.now();
	timers.collect(timeline);
	const auto sections = timeline.takeSections();
	ASSERT_EQ(sections.size(), std::size_t(kPasses));
	for (const Timeline::Section& section : sections)
	{
		EXPECT_EQ(section.track, Timeline::Track::gpu);
		EXPECT_GE(section.duration_ms, 0.0);
		// The clocks agree to well below a millisecond.
		EXPECT_GE(section.start_ms, begin - 1.0);
		EXPECT_LE(section.start_ms + section.duration_ms, end + 1.0);
	}
	EXPECT_GT(timeline.totalGpu(), 0.0);
}

// Each group of a dispatch runs the shader as often as its size says.
TEST_F(GpuTest, CountsInvocationsOfPasses)
{
	if (!device().features().pipelineStatisticsQuery)
		GTEST_SKIP() << device().name() << " does not count invocations";
	const auto spirv = gpu::compileComputeShader("#version 460\nlayout(local_size_x = 32) in;\nvoid main() {}\n");
	ASSERT_TRUE(spirv);
	gpu::ComputePipelineInfo info;
	info.spirv = *spirv;
	const auto pipeline = gpu::Pipeline::create(device(), info, "empty");
	ASSERT_TRUE(pipeline);
	Timeline timeline;
	gpu::Timers timers(device());
	const auto dispatch = [&](const char* pass, std::uint32_t groups)
	{
		EXPECT_TRUE(gpu::runOnce(device(), "dispatch",
		                         [&](VkCommandBuffer commands)
		                         {
			                         const gpu::TimedPass timed(timers, commands, pass);
			                         pipeline->bind(commands);
			                         vkCmdDispatch(commands, groups, 1, 1);
		                         }));
	};
	dispatch("a", 3); // nobody counts yet
	gpu::countInvocations(true);
	for (int i = 0; i < 600; ++i) // more than one pool of queries holds
		dispatch("a", 5);
	dispatch("b", 7);
	gpu::countInvocations(false);
	dispatch("a", 3);
	timers.collect(timeline);
	const gpu::PassInvocations counted = gpu::takeInvocations();
	ASSERT_EQ(counted.size(), 2u);
	EXPECT_EQ(counted.at("a"), (gpu::Invocations{.computes = std::uint64_t(600) * 5 * 32}));
	EXPECT_EQ(counted.at("b"), (gpu::Invocations{.computes = std::uint64_t(7) * 32}));
	EXPECT_TRUE(gpu::takeInvocations().empty());
}

} // namespace vp::test
