#pragma once

#include "gpu/buffer.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace vp::render
{

// Makes room for `bytes` in `buffer`. Keeps the buffer if it is large enough. By default the host writes it.
Status makeRoom(gpu::Device& device, gpu::Buffer& buffer, VkDeviceSize bytes, VkBufferUsageFlags usage,
                std::string_view name, gpu::Memory memory = gpu::Memory::upload);

// A buffer that the host writes and shaders read as texels.
struct HostTexels
{
	gpu::Buffer buffer;
	gpu::TexelView texels;

	Status put(gpu::Device& device, std::span<const std::byte> bytes, VkFormat format, std::string_view name);
};

} // namespace vp::render
