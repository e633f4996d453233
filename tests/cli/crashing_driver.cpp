// Preloaded, it stands in for a driver: libvulkan_crashing.so crashes where pipelines are made.
#include <vulkan/vulkan.h>

#include <cstdint>

extern "C" __attribute__((visibility("default"))) VkResult
vkCreateGraphicsPipelines(VkDevice, VkPipelineCache, std::uint32_t, const VkGraphicsPipelineCreateInfo*,
                          const VkAllocationCallbacks*, VkPipeline*)
{
	volatile int* nowhere = nullptr;
	*nowhere = 1;
	return VK_SUCCESS;
}
