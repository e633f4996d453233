#pragma once

#include "gpu/vulkan.h"

#include <bit>

namespace vp::gpu
{

// llvmpipe compiles a shader anew (some 300 ms) when a texel buffer's size turns from a power of two to another number, or back.
// No texel buffer gets such a size, so that what was compiled for one serves all.
constexpr VkDeviceSize allocatedSize(VkDeviceSize size, VkBufferUsageFlags usage)
{
	constexpr VkBufferUsageFlags kTexels =
	    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
	constexpr VkDeviceSize kTexelBytes = 16; // of the largest format
	return (usage & kTexels) && std::has_single_bit(size) ? size + kTexelBytes : size;
}

} // namespace vp::gpu
