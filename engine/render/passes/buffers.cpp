#include "render/passes/buffers.h"

#include <algorithm>
#include <cstring>

namespace vp::render
{

Status makeRoom(gpu::Device& device, gpu::Buffer& buffer, VkDeviceSize bytes, VkBufferUsageFlags usage,
                std::string_view name, gpu::Memory memory)
{
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	// Half as much again: a scene that grows a little does not allocate each time. In whole texels of any format.
	const VkDeviceSize room = std::max<VkDeviceSize>((bytes + bytes / 2 + 15) / 16 * 16, 1024);
	auto made = gpu::Buffer::create(device, room, usage, memory, name);
	if (!made)
		return made.error();
	buffer = std::move(*made);
	return Nothing{};
}

Status HostTexels::put(gpu::Device& device, std::span<const std::byte> bytes, VkFormat format, std::string_view name)
{
	if (!buffer || buffer.size() < bytes.size())
	{
		if (Status room = makeRoom(device, buffer, bytes.size(), VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT, name); !room)
			return room;
		auto view = gpu::TexelView::create(buffer, format, name);
		if (!view)
			return view.error();
		texels = std::move(*view);
	}
	std::memcpy(buffer.mapped(), bytes.data(), bytes.size());
	buffer.flush();
	return Nothing{};
}

} // namespace vp::render
