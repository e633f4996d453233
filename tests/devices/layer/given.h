#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

namespace vp::layer
{

/// VPROBE_LAYER_GIVE=executables gives a device VK_KHR_pipeline_executable_properties, which software devices lack.
/// Each pipeline then has one executable, with figures of each format (given.cpp).
bool givesExecutables();
void addGivenExtension(std::vector<VkExtensionProperties>& extensions);
/// Turns on the feature in a chain of structures, if it is asked for there.
void addGivenFeature(void* chain);
/// Takes the feature out of a chain, since the next layer knows nothing of it. Returns the chain without it.
const void* withoutGivenFeature(const void* chain);

VKAPI_ATTR VkResult VKAPI_CALL givenExecutables(VkDevice device, const VkPipelineInfoKHR* pipeline,
                                                std::uint32_t* count, VkPipelineExecutablePropertiesKHR* told);
VKAPI_ATTR VkResult VKAPI_CALL givenStatistics(VkDevice device, const VkPipelineExecutableInfoKHR* executable,
                                               std::uint32_t* count, VkPipelineExecutableStatisticKHR* told);

} // namespace vp::layer
