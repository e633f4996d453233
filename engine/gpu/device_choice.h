#pragma once

#include "base/result.h"
#include "gpu/device.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vp::gpu
{

// A device that was found, and what it lacks.
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

Candidate examine(VkPhysicalDevice device, bool swapchain);

// Returns a device error that names what the candidate lacks.
Error unusable(const Candidate& candidate);

// The features for creating a device: those that the engine needs, and those that it uses if the device has them. all()
// is for vkCreateDevice, and refers to the other members.
class WantedFeatures
{
public:
	explicit WantedFeatures(VkPhysicalDevice device);
	WantedFeatures(const WantedFeatures&) = delete;
	WantedFeatures& operator=(const WantedFeatures&) = delete;

	const VkPhysicalDeviceFeatures2& all() const { return features_; }

private:
	VkPhysicalDeviceVulkan13Features v13_{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
	VkPhysicalDeviceVulkan12Features v12_{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13_};
	VkPhysicalDeviceFeatures2 features_{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12_};
};

// The best device (discrete before integrated, virtual and CPU), or the one that `name_or_index` says.
Result<Candidate> chooseDevice(VkInstance instance, const DeviceOptions& options);

} // namespace vp::gpu
