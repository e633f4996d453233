#pragma once

#include "gpu/vulkan.h"

#include <bit>

namespace vp::gpu
{

// llvmpipe compiles a shader again, for some 100 ms, when of a texel buffer it reads changes whether the size is a
// power of two, or whether bits 8 to 15 of the size are all zero (it takes them for a mip level). All texel buffers get
// a size that is neither, so that what was compiled for one serves the others.
constexpr VkDeviceSize allocatedSize(VkDeviceSize size, VkBufferUsageFlags usage)
{
	constexpr VkBufferUsageFlags kTexels =
	    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
	if (!(usage & kTexels))
		return size;
	if ((size >> 8 & 0xFFu) == 0)
		size += 0x100;
	return std::has_single_bit(size) ? size + 0x100 : size;
}

} // namespace vp::gpu
