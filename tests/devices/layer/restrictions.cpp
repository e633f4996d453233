#include "restrictions.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace vp::layer
{

Restrictions Restrictions::fromEnvironment()
{
	Restrictions has;
	const std::map<std::string, bool*> names{
	    {"no-float64", &has.float64},          {"small-uniforms", &has.uniforms},
	    {"small-storage", &has.storage},       {"small-texels", &has.texels},
	    {"no-timestamps", &has.timestamps},    {"one-queue", &has.queues},
	    {"split-memory", &has.mapped_memory},  {"few-descriptors", &has.descriptors},
	    {"few-allocations", &has.allocations}, {"no-extensions", &has.extensions},
	    {"no-options", &has.options},          {"no-windows", &has.windows}};
	const char* set = std::getenv("VPROBE_LAYER_RESTRICT");
	std::istringstream words(set ? set : "");
	for (std::string word; std::getline(words, word, ',');)
	{
		const auto found = names.find(word);
		if (found == names.end())
		{
			std::fprintf(stderr, "VPROBE_LAYER_RESTRICT: no restriction is named %s\n", word.c_str());
			std::_Exit(99);
		}
		*found->second = false;
	}
	return has;
}

// The least values are those of "Required Limits" in the specification of Vulkan 1.3.
void Restrictions::limit(VkPhysicalDeviceProperties& properties) const
{
	VkPhysicalDeviceLimits& limits = properties.limits;
	const auto atMost = [](auto& value, auto most) { value = std::min<std::decay_t<decltype(value)>>(value, most); };
	if (!uniforms)
		atMost(limits.maxUniformBufferRange, 16384u);
	if (!storage)
		atMost(limits.maxStorageBufferRange, 1u << 27);
	if (!texels)
		atMost(limits.maxTexelBufferElements, 65536u);
	if (!timestamps)
		limits.timestampComputeAndGraphics = VK_FALSE;
	if (!allocations)
		atMost(limits.maxMemoryAllocationCount, kAllocations);
	if (!descriptors)
	{
		atMost(limits.maxBoundDescriptorSets, 4u);
		atMost(limits.maxPerStageDescriptorSamplers, 16u);
		atMost(limits.maxPerStageDescriptorUniformBuffers, 12u);
		atMost(limits.maxPerStageDescriptorStorageBuffers, 4u);
		atMost(limits.maxPerStageDescriptorSampledImages, 16u);
		atMost(limits.maxPerStageDescriptorStorageImages, 4u);
		atMost(limits.maxPerStageDescriptorInputAttachments, 4u);
		atMost(limits.maxPerStageResources, 128u);
		atMost(limits.maxDescriptorSetSamplers, 96u);
		atMost(limits.maxDescriptorSetUniformBuffers, 72u);
		atMost(limits.maxDescriptorSetStorageBuffers, 24u);
		atMost(limits.maxDescriptorSetSampledImages, 96u);
		atMost(limits.maxDescriptorSetStorageImages, 24u);
	}
}

void Restrictions::limit(VkPhysicalDeviceFeatures& features) const
{
	if (!options)
	{
		const VkBool32 float64_too = features.shaderFloat64;
		const VkBool32 fragment_stores = features.fragmentStoresAndAtomics;
		features = {};
		features.shaderFloat64 = float64_too;
		features.fragmentStoresAndAtomics = fragment_stores;
		features.robustBufferAccess = VK_TRUE; // promised
	}
	if (!float64)
		features.shaderFloat64 = VK_FALSE;
}

// One type that the host maps becomes two: the device's own, and the host's. The layer keeps both in the first.
void Restrictions::limit(VkPhysicalDeviceMemoryProperties& memory) const
{
	if (mapped_memory)
		return;
	const VkMemoryType all = memory.memoryTypes[0];
	memory.memoryTypeCount = 2;
	memory.memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
	memory.memoryTypes[1] = {all.propertyFlags & ~VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT),
	                         all.heapIndex};
}

void Restrictions::limit(std::vector<VkQueueFamilyProperties>& families) const
{
	if (!queues)
		families.resize(1);
	for (VkQueueFamilyProperties& family : families)
	{
		if (!queues)
			family.queueCount = 1;
		if (!timestamps)
			family.timestampValidBits = 0;
	}
}

void Restrictions::limitChained(void* chain) const
{
	for (auto* next = static_cast<VkBaseOutStructure*>(chain); next; next = next->pNext)
		if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES && !float64)
			reinterpret_cast<VkPhysicalDeviceFloatControlsProperties*>(next)->shaderRoundingModeRTEFloat64 = VK_FALSE;
}

bool Restrictions::hides(const std::string& extension) const
{
	return !extensions && extension != VK_KHR_SWAPCHAIN_EXTENSION_NAME;
}

} // namespace vp::layer
