#include "given.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace vp::layer
{

namespace
{

using Feature = VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR;

bool isFeature(const VkBaseInStructure* structure)
{
	return structure->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
}

VkPipelineExecutableStatisticKHR statistic(const char* name, VkPipelineExecutableStatisticFormatKHR format,
                                           VkPipelineExecutableStatisticValueKHR value)
{
	VkPipelineExecutableStatisticKHR made{};
	made.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
	std::snprintf(made.name, sizeof(made.name), "%s", name);
	made.format = format;
	made.value = value;
	return made;
}

// Fills a list of the caller as Vulkan's functions do.
template <class List, class Told>
VkResult give(const List& list, std::uint32_t* count, Told* told)
{
	const auto all = static_cast<std::uint32_t>(list.size());
	const std::uint32_t given = told ? std::min(*count, all) : all;
	if (told)
		std::copy_n(list.begin(), given, told);
	*count = given;
	return given < all ? VK_INCOMPLETE : VK_SUCCESS;
}

} // namespace

bool givesExecutables()
{
	const char* set = std::getenv("VPROBE_LAYER_GIVE");
	return set && std::string_view(set) == "executables";
}

void addGivenExtension(std::vector<VkExtensionProperties>& extensions)
{
	if (!givesExecutables())
		return;
	VkExtensionProperties given{};
	std::strcpy(given.extensionName, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
	given.specVersion = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_SPEC_VERSION;
	extensions.push_back(given);
}

void addGivenFeature(void* chain)
{
	for (auto* next = static_cast<VkBaseOutStructure*>(chain); next && givesExecutables(); next = next->pNext)
		if (isFeature(reinterpret_cast<const VkBaseInStructure*>(next)))
			reinterpret_cast<Feature*>(next)->pipelineExecutableInfo = VK_TRUE;
}

const void* withoutGivenFeature(const void* chain)
{
	const auto* first = static_cast<const VkBaseInStructure*>(chain);
	while (first && givesExecutables() && isFeature(first))
		first = first->pNext;
	for (const auto* at = first; at && givesExecutables() && at->pNext; at = at->pNext)
		if (isFeature(at->pNext))
			const_cast<VkBaseInStructure*>(at)->pNext = at->pNext->pNext;
	return first;
}

VKAPI_ATTR VkResult VKAPI_CALL givenExecutables(VkDevice, const VkPipelineInfoKHR*, std::uint32_t* count,
                                                VkPipelineExecutablePropertiesKHR* told)
{
	std::array<VkPipelineExecutablePropertiesKHR, 1> list{};
	list[0].sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR;
	list[0].subgroupSize = 16;
	std::strcpy(list[0].name, "given shader");
	return give(list, count, told);
}

VKAPI_ATTR VkResult VKAPI_CALL givenStatistics(VkDevice, const VkPipelineExecutableInfoKHR*, std::uint32_t* count,
                                               VkPipelineExecutableStatisticKHR* told)
{
	const std::array list{statistic("registers", VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR, {.u64 = 42}),
	                      statistic("spills", VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR, {.b32 = VK_TRUE}),
	                      statistic("balance", VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR, {.i64 = -3}),
	                      statistic("occupancy", VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR, {.f64 = 0.75}),
	                      statistic("bytes", VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR, {.u64 = 1024})};
	return give(list, count, told);
}

} // namespace vp::layer
