#include "gpu/upload.h"

#include "gpu/commands.h"
#include "gpu/vk_check.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace vp::gpu
{

// Large enough to hide the submission's latency, small enough to stay in a discrete device's host-visible window.
constexpr VkDeviceSize kStagingBytes = VkDeviceSize(32) << 20;

Status fillBuffer(Buffer& buffer, std::size_t elements, std::size_t element_bytes,
                  const std::function<void(std::byte*, std::size_t, std::size_t)>& fill)
{
	assert(elements * element_bytes <= buffer.size());
	if (elements == 0)
		return Nothing{};
	if (buffer.mapped())
	{
		fill(buffer.mappedAs<std::byte>(), 0, elements);
		buffer.flush();
		return Nothing{};
	}
	const std::size_t run = std::clamp<std::size_t>(kStagingBytes / element_bytes, 1, elements);
	Result<Buffer> staging = Buffer::create(buffer.device(), run * element_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
	                                        Memory::upload, "staging");
	if (!staging)
		return staging.error();
	for (std::size_t first = 0; first < elements; first += run)
	{
		const std::size_t count = std::min(run, elements - first);
		fill(staging->mappedAs<std::byte>(), first, count);
		staging->flush();
		Status copied =
		    runOnce(buffer.device(), "upload",
		            [&](VkCommandBuffer commands)
		            {
			            const VkBufferCopy region{0, first * element_bytes, count * element_bytes};
			            vkCmdCopyBuffer(commands, staging->handle(), buffer.handle(), 1, &region);
			            memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
			                          VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT);
		            });
		if (!copied)
			return copied.error();
	}
	return Nothing{};
}

Status upload(Buffer& buffer, std::span<const std::byte> bytes)
{
	return fillBuffer(buffer, bytes.size(), 1,
	                  [&](std::byte* destination, std::size_t first, std::size_t count)
	                  { std::memcpy(destination, bytes.data() + first, count); });
}

Result<Buffer> uploaded(Device& device, std::span<const std::byte> bytes, VkBufferUsageFlags usage,
                        std::string_view name)
{
	Result<Buffer> buffer = Buffer::create(device, std::max<std::size_t>(bytes.size(), 4),
	                                       usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::device, name);
	if (!buffer)
		return buffer.error();
	if (Status copied = upload(*buffer, bytes); !copied)
		return copied.error();
	return buffer;
}

Status download(const Buffer& buffer, VkDeviceSize offset, std::span<std::byte> bytes)
{
	assert(offset + bytes.size() <= buffer.size());
	if (bytes.empty())
		return Nothing{};
	if (buffer.mapped())
	{
		// Before this call, the code that wrote the buffer on the GPU must wait for it, with a barrier to the host.
		buffer.invalidate();
		std::memcpy(bytes.data(), buffer.mappedAs<std::byte>() + offset, bytes.size());
		return Nothing{};
	}
	Result<Buffer> readback =
	    Buffer::create(buffer.device(), bytes.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::readback, "readback");
	if (!readback)
		return readback.error();
	Status copied =
	    runOnce(buffer.device(), "download",
	            [&](VkCommandBuffer commands)
	            {
		            memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
		                          VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
		            const VkBufferCopy region{offset, 0, bytes.size()};
		            vkCmdCopyBuffer(commands, buffer.handle(), readback->handle(), 1, &region);
		            memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
		                          VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
	            });
	if (!copied)
		return copied.error();
	readback->invalidate();
	std::memcpy(bytes.data(), readback->mapped(), bytes.size());
	return Nothing{};
}

} // namespace vp::gpu
