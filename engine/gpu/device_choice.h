#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::gpu
{

// A device found, with what it lacks for our work.
struct Candidate
{
	VkPhysicalDevice handle = VK_NULL_HANDLE;
	std::string name;
	VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
	std::uint32_t queue_family = 0;
	std::vector<std::string> lacks;
	std::vector<std::string> extensions;

	bool has(const char* extension) const;
};

// The best device (discrete before integrated, virtual and CPU), or the one that `name_or_index` says.
Result<Candidate> chooseDevice(VkInstance instance, const std::string& name_or_index, bool swapchain);

} // namespace vp::gpu
