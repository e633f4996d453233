#include "gpu/device_speed.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace vp::gpu
{

namespace
{

constexpr VkDeviceSize kFilledBytes = VkDeviceSize(8) << 20; // a picture of 1920 x 1080
constexpr int kSpeedTries = 8;
constexpr double kLongestMs = 50.0; // for all tries of one kind

// Returns the least time of a submission, in ms.
Result<double> leastMs(Commands& commands, const std::function<void(VkCommandBuffer)>& record)
{
	double least = std::numeric_limits<double>::infinity();
	double all = 0.0;
	for (int k = 0; k < kSpeedTries && all < kLongestMs; ++k)
	{
		const Result<VkCommandBuffer> buffer = commands.begin();
		if (!buffer)
			return buffer.error();
		record(*buffer);
		const auto start = std::chrono::steady_clock::now();
		if (Status done = commands.submitAndWait(); !done)
			return done.error();
		const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
		least = std::min(least, ms);
		all += ms;
	}
	return least;
}

} // namespace

Result<DeviceSpeed> measureSpeed(Device& device)
{
	Result<Commands> commands = Commands::create(device, "speed");
	if (!commands)
		return commands.error();
	const Result<Buffer> pixels =
	    Buffer::create(device, kFilledBytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::device, "speed");
	if (!pixels)
		return pixels.error();
	const Result<double> empty = leastMs(*commands, [](VkCommandBuffer) {});
	if (!empty)
		return empty.error();
	const Result<double> filled =
	    leastMs(*commands,
	            [&](VkCommandBuffer buffer)
	            {
		            memoryBarrier(buffer, VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
		                          VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
		            vkCmdFillBuffer(buffer, pixels->handle(), 0, kFilledBytes, 0);
	            });
	if (!filled)
		return filled.error();
	return DeviceSpeed{*empty, 1e3 * static_cast<double>(kFilledBytes / 4) / *filled};
}

} // namespace vp::gpu
