#pragma once

#include "gpu/buffer.h"

namespace vp::gpu
{

// Device memory for one buffer or image.
struct Allocation
{
	VkDeviceMemory memory = VK_NULL_HANDLE;
	void* mapped = nullptr;
	bool coherent = false;
};

Result<Allocation> allocate(Device& device, const VkMemoryRequirements& requirements, Memory kind,
                            std::string_view name);

} // namespace vp::gpu
