#include "gpu/device_choice.h"

#include "gpu/vk_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace vp::gpu
{

namespace
{
std::vector<std::string> extensionsOf(VkPhysicalDevice device)
{
	std::uint32_t count = 0;
	vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
	std::vector<VkExtensionProperties> properties(count);
	vkEnumerateDeviceExtensionProperties(device, nullptr, &count, properties.data());
	std::vector<std::string> names;
	for (const VkExtensionProperties& extension : properties)
		names.emplace_back(extension.extensionName);
	return names;
}

std::optional<std::uint32_t> graphicsAndComputeFamily(VkPhysicalDevice device)
{
	std::uint32_t count = 0;
	vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
	std::vector<VkQueueFamilyProperties> families(count);
	vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
	constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
	for (std::uint32_t i = 0; i < count; ++i)
		if ((families[i].queueFlags & kNeeded) == kNeeded)
			return i;
	return {};
}

std::vector<std::string> missingFeatures(VkPhysicalDevice device)
{
	VkPhysicalDeviceVulkan13Features v13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
	VkPhysicalDeviceVulkan12Features v12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES, &v13};
	VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12};
	vkGetPhysicalDeviceFeatures2(device, &features);
	std::vector<std::string> missing;
	const auto need = [&](VkBool32 present, const char* name)
	{
		if (!present)
			missing.emplace_back(name);
	};
	need(features.features.fragmentStoresAndAtomics, "fragmentStoresAndAtomics");
	need(v13.synchronization2, "synchronization2");
	need(v13.dynamicRendering, "dynamicRendering");
	need(v13.maintenance4, "maintenance4");
	need(v12.timelineSemaphore, "timelineSemaphore");
	need(v12.scalarBlockLayout, "scalarBlockLayout");
	need(v12.hostQueryReset, "hostQueryReset");
	return missing;
}

// A format that drawing uses in a way that Vulkan does not promise.
void requireFormats(VkPhysicalDevice device, std::vector<std::string>& missing)
{
	VkFormatProperties depth{};
	vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT, &depth);
	constexpr VkFormatFeatureFlags kNeeded =
	    VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
	if ((depth.optimalTilingFeatures & kNeeded) != kNeeded)
		missing.emplace_back("depth of 32 bits (D32_SFLOAT)");
}

} // namespace

Candidate examine(VkPhysicalDevice device, bool swapchain)
{
	VkPhysicalDeviceProperties properties;
	vkGetPhysicalDeviceProperties(device, &properties);
	Candidate candidate;
	candidate.handle = device;
	candidate.name = properties.deviceName;
	candidate.type = properties.deviceType;
	candidate.extensions = extensionsOf(device);
	if (properties.apiVersion < VK_API_VERSION_1_3)
		candidate.lacks.push_back("Vulkan 1.3");
	else
	{
		candidate.lacks = missingFeatures(device);
		requireFormats(device, candidate.lacks);
	}
	if (const auto family = graphicsAndComputeFamily(device))
		candidate.queue_family = *family;
	else
		candidate.lacks.push_back("a queue for graphics and compute");
	if (swapchain && !candidate.has(VK_KHR_SWAPCHAIN_EXTENSION_NAME))
		candidate.lacks.push_back("windows (" VK_KHR_SWAPCHAIN_EXTENSION_NAME ")");
	return candidate;
}

namespace
{

int rank(VkPhysicalDeviceType type)
{
	switch (type)
	{
	case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
		return 0;
	case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
		return 1;
	case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
		return 2;
	case VK_PHYSICAL_DEVICE_TYPE_CPU:
		return 3;
	default:
		return 4;
	}
}

std::string lowered(std::string text)
{
	std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
	return text;
}

bool isIndex(const std::string& text)
{
	return !text.empty() && text.size() < 4 &&
	       std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}
} // namespace

Error unusable(const Candidate& candidate)
{
	return Error{ErrorKind::device, fmt::format("device {} lacks {}; a newer driver may have it", candidate.name,
	                                            fmt::join(candidate.lacks, ", "))};
}

WantedFeatures::WantedFeatures(VkPhysicalDevice device)
{
	v13_.synchronization2 = v13_.dynamicRendering = v13_.maintenance4 = VK_TRUE;
	v12_.timelineSemaphore = v12_.scalarBlockLayout = v12_.hostQueryReset = VK_TRUE;
	VkPhysicalDeviceFeatures present;
	vkGetPhysicalDeviceFeatures(device, &present);
	features_.features.fragmentStoresAndAtomics = present.fragmentStoresAndAtomics; // surfaces are drawn with it
	features_.features.shaderFloat64 = present.shaderFloat64;
}

bool Candidate::has(const char* extension) const
{
	return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

Result<Candidate> chooseDevice(VkInstance instance, const DeviceOptions& options)
{
	const std::string& name_or_index = options.name_or_index;
	std::uint32_t count = 0;
	VkResult listed = vkEnumeratePhysicalDevices(instance, &count, nullptr);
	std::vector<VkPhysicalDevice> devices(count);
	if (listed == VK_SUCCESS)
		listed = vkEnumeratePhysicalDevices(instance, &count, devices.data());
	if (listed < 0 || count == 0)
		return Error{ErrorKind::device,
		             "no Vulkan device; install mesa-vulkan-drivers, or the driver of your graphics card"};
	devices.resize(count);

	std::vector<Candidate> candidates;
	std::string list;
	for (const VkPhysicalDevice device : devices)
	{
		candidates.push_back(examine(device, options.swapchain));
		list += fmt::format("{}{}: {}", list.empty() ? "" : ", ", candidates.size() - 1, candidates.back().name);
	}

	if (isIndex(name_or_index))
	{
		const std::size_t index = std::stoul(name_or_index);
		if (index >= candidates.size())
			return Error{ErrorKind::device, fmt::format("no device {}; there are {}", index, list)};
		return candidates[index].lacks.empty() ? Result<Candidate>(candidates[index]) : unusable(candidates[index]);
	}
	std::erase_if(candidates, [&](const Candidate& candidate)
	              { return lowered(candidate.name).find(lowered(name_or_index)) == std::string::npos; });
	if (candidates.empty())
		return Error{ErrorKind::device, fmt::format("no device is named {}; there are {}", name_or_index, list)};
	std::stable_sort(candidates.begin(), candidates.end(),
	                 [&](const Candidate& a, const Candidate& b)
	                 {
		                 if (a.lacks.empty() != b.lacks.empty())
			                 return a.lacks.empty();
		                 if ((a.name == options.avoid) != (b.name == options.avoid))
			                 return b.name == options.avoid;
		                 return rank(a.type) < rank(b.type);
	                 });
	return candidates.front().lacks.empty() ? Result<Candidate>(candidates.front()) : unusable(candidates.front());
}

} // namespace vp::gpu
