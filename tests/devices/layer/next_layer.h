#pragma once

#include <vulkan/vulkan.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

// The functions of the next layer, or of the driver, that a layer calls.
namespace vp::layer
{

// Calls of a device that may fail, and what with.
#define VP_CALLS(X)                                                                                                    \
	X(vkAllocateMemory, kMemory)                                                                                       \
	X(vkMapMemory, kMemory)                                                                                            \
	X(vkFlushMappedMemoryRanges, kMemory)                                                                              \
	X(vkInvalidateMappedMemoryRanges, kMemory)                                                                         \
	X(vkBindBufferMemory, kMemory)                                                                                     \
	X(vkBindImageMemory, kMemory)                                                                                      \
	X(vkCreateBuffer, kMemory)                                                                                         \
	X(vkCreateBufferView, kMemory)                                                                                     \
	X(vkCreateImage, kMemory)                                                                                          \
	X(vkCreateImageView, kMemory)                                                                                      \
	X(vkCreateSampler, kMemory)                                                                                        \
	X(vkCreateShaderModule, kMemory)                                                                                   \
	X(vkCreatePipelineCache, kHostMemory)                                                                              \
	X(vkCreateGraphicsPipelines, kMemory)                                                                              \
	X(vkCreateComputePipelines, kMemory)                                                                               \
	X(vkCreatePipelineLayout, kMemory)                                                                                 \
	X(vkCreateDescriptorSetLayout, kMemory)                                                                            \
	X(vkCreateDescriptorPool, kMemory)                                                                                 \
	X(vkAllocateDescriptorSets, kMemory)                                                                               \
	X(vkCreateSemaphore, kMemory)                                                                                      \
	X(vkCreateFence, kMemory)                                                                                          \
	X(vkCreateQueryPool, kMemory)                                                                                      \
	X(vkCreateCommandPool, kMemory)                                                                                    \
	X(vkResetCommandPool, kDeviceMemory)                                                                               \
	X(vkAllocateCommandBuffers, kMemory)                                                                               \
	X(vkBeginCommandBuffer, kMemory)                                                                                   \
	X(vkEndCommandBuffer, kMemory)                                                                                     \
	X(vkResetCommandBuffer, kDeviceMemory)                                                                             \
	X(vkQueueSubmit, kAll)                                                                                             \
	X(vkQueueSubmit2, kAll)                                                                                            \
	X(vkQueueWaitIdle, kAll)                                                                                           \
	X(vkDeviceWaitIdle, kAll)                                                                                          \
	X(vkWaitForFences, kAll)                                                                                           \
	X(vkGetFenceStatus, kAll)                                                                                          \
	X(vkWaitSemaphores, kAll)                                                                                          \
	X(vkGetSemaphoreCounterValue, kAll)                                                                                \
	X(vkGetQueryPoolResults, kAll)                                                                                     \
	X(vkGetCalibratedTimestampsEXT, kMemory)                                                                           \
	X(vkCreateSwapchainKHR, kAll | kSurface)                                                                           \
	X(vkAcquireNextImageKHR, kAcquiring)                                                                               \
	X(vkQueuePresentKHR, kShowing)

enum Slot : std::size_t
{
#define VP_SLOT(name, bits) slot_##name,
	VP_CALLS(VP_SLOT)
#undef VP_SLOT
	    kSlots
};

// Functions of an instance that the layer has, too.
#define VP_INSTANCE_CALLS(X)                                                                                           \
	X(vkDestroyInstance)                                                                                               \
	X(vkGetPhysicalDeviceProperties)                                                                                   \
	X(vkGetPhysicalDeviceProperties2)                                                                                  \
	X(vkGetPhysicalDeviceFeatures)                                                                                     \
	X(vkGetPhysicalDeviceFeatures2)                                                                                    \
	X(vkGetPhysicalDeviceMemoryProperties)                                                                             \
	X(vkGetPhysicalDeviceMemoryProperties2)                                                                            \
	X(vkGetPhysicalDeviceQueueFamilyProperties)                                                                        \
	X(vkEnumerateDeviceExtensionProperties)                                                                            \
	X(vkGetPhysicalDeviceSurfaceSupportKHR)

// Asked for while the instance is made: later the loader may give this layer's own functions back.
struct NextInstance
{
	VkInstance handle;
	PFN_vkGetInstanceProcAddr get;
#define VP_MEMBER(name) PFN_##name name;
	VP_INSTANCE_CALLS(VP_MEMBER)
#undef VP_MEMBER
};

struct NextDevice
{
	VkDevice handle;
	PFN_vkGetDeviceProcAddr get;
	PFN_vkVoidFunction calls[kSlots];
	PFN_vkDestroyDevice destroy;
	PFN_vkFreeMemory free_memory;
	PFN_vkGetBufferMemoryRequirements buffer_requirements;
	PFN_vkGetImageMemoryRequirements image_requirements;
	std::atomic<std::uint32_t> allocations{0};
};

} // namespace vp::layer
