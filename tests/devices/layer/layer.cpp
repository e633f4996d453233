// A Vulkan layer for tests. It takes features and limits from a device (restrictions.h), gives it an extension
// (given.h), and lets calls fail (faults.h).
#include "faults.h"
#include "given.h"
#include "next_layer.h"
#include "restrictions.h"

#include <vulkan/vk_layer.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <iterator>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <vector>

namespace vp::layer
{

namespace
{

const Restrictions& restrictions()
{
	static const Restrictions made = Restrictions::fromEnvironment();
	return made;
}

Faults& faults()
{
	static Faults made;
	return made;
}

// The loader's table of functions is the first word of each handle, and the same for all handles of a device.
using Key = void*;

template <class Handle>
Key keyOf(Handle handle)
{
	return *reinterpret_cast<void**>(handle);
}

std::shared_mutex mutex;
std::map<Key, NextInstance> instances;
std::map<Key, NextDevice> devices;

template <class Handle>
NextInstance& instanceOf(Handle handle)
{
	const std::shared_lock lock(mutex);
	return instances.at(keyOf(handle));
}

template <class Handle>
NextDevice& deviceOf(Handle handle)
{
	const std::shared_lock lock(mutex);
	return devices.at(keyOf(handle));
}

// A device that is lost works on nothing any more.
VkResult failed(const NextDevice& next, VkResult fault)
{
	if (fault == VK_ERROR_DEVICE_LOST)
		reinterpret_cast<PFN_vkDeviceWaitIdle>(next.calls[slot_vkDeviceWaitIdle])(next.handle);
	return fault;
}

template <class Function>
struct Failing;

// A call that may fail, else the next layer's.
template <class Handle, class... Rest>
struct Failing<VkResult(VKAPI_PTR*)(Handle, Rest...)>
{
	using Function = VkResult(VKAPI_PTR*)(Handle, Rest...);

	template <Slot slot, unsigned bits>
	static VKAPI_ATTR VkResult VKAPI_CALL call(Handle handle, Rest... rest)
	{
		const NextDevice& next = deviceOf(handle);
		if (const auto fault = faults().next(bits))
		{
			// A picture that no longer fits is waited for all the same.
			if (slot == slot_vkQueuePresentKHR &&
			    (*fault == VK_ERROR_SURFACE_LOST_KHR || *fault == VK_ERROR_OUT_OF_DATE_KHR))
				reinterpret_cast<Function>(next.calls[slot])(handle, rest...);
			return failed(next, *fault);
		}
		return reinterpret_cast<Function>(next.calls[slot])(handle, rest...);
	}
};

VKAPI_ATTR VkResult VKAPI_CALL allocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                              const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory)
{
	if (const auto fault = faults().next(kMemory))
		return *fault;
	NextDevice& next = deviceOf(device);
	VkMemoryAllocateInfo asked = *info;
	if (!restrictions().mapped_memory)
		asked.memoryTypeIndex = 0;
	if (++next.allocations > kAllocations && !restrictions().allocations)
	{
		--next.allocations;
		return VK_ERROR_TOO_MANY_OBJECTS;
	}
	const VkResult made =
	    reinterpret_cast<PFN_vkAllocateMemory>(next.calls[slot_vkAllocateMemory])(device, &asked, callbacks, memory);
	if (made != VK_SUCCESS)
		--next.allocations;
	return made;
}

VKAPI_ATTR void VKAPI_CALL freeMemory(VkDevice device, VkDeviceMemory memory, const VkAllocationCallbacks* callbacks)
{
	NextDevice& next = deviceOf(device);
	if (memory)
		--next.allocations;
	next.free_memory(device, memory, callbacks);
}

// Splits memory types: two types stand for one (Restrictions::limit).
void splitTypes(VkMemoryRequirements& requirements)
{
	if (!restrictions().mapped_memory)
		requirements.memoryTypeBits = 3;
}

VKAPI_ATTR void VKAPI_CALL bufferRequirements(VkDevice device, VkBuffer buffer, VkMemoryRequirements* requirements)
{
	deviceOf(device).buffer_requirements(device, buffer, requirements);
	splitTypes(*requirements);
}

VKAPI_ATTR void VKAPI_CALL imageRequirements(VkDevice device, VkImage image, VkMemoryRequirements* requirements)
{
	deviceOf(device).image_requirements(device, image, requirements);
	splitTypes(*requirements);
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* callbacks)
{
	const Key key = keyOf(device);
	deviceOf(device).destroy(device, callbacks);
	const std::unique_lock lock(mutex);
	devices.erase(key);
}

// The link to the next layer, which is taken out of the chain.
template <class Info, class Link>
const Link* takeLink(const void* chain, VkStructureType type)
{
	for (auto* next = static_cast<const Info*>(chain); next; next = static_cast<const Info*>(next->pNext))
		if (next->sType == type && next->function == VK_LAYER_LINK_INFO)
		{
			const Link* link = next->u.pLayerInfo;
			const_cast<Info*>(next)->u.pLayerInfo = link->pNext;
			return link;
		}
	return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info, const VkAllocationCallbacks* callbacks,
                                              VkInstance* instance)
{
	const auto* link = takeLink<VkLayerInstanceCreateInfo, VkLayerInstanceLink>(
	    info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
	const PFN_vkGetInstanceProcAddr get = link->pfnNextGetInstanceProcAddr;
	const auto create = reinterpret_cast<PFN_vkCreateInstance>(get(nullptr, "vkCreateInstance"));
	const VkResult made = create(info, callbacks, instance);
	if (made == VK_SUCCESS)
	{
		const std::unique_lock lock(mutex);
		NextInstance& next = instances[keyOf(*instance)];
		next.handle = *instance;
		next.get = get;
#define VP_LOAD(name) next.name = reinterpret_cast<PFN_##name>(get(*instance, #name));
		VP_INSTANCE_CALLS(VP_LOAD)
#undef VP_LOAD
	}
	return made;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance, const VkAllocationCallbacks* callbacks)
{
	const Key key = keyOf(instance);
	instanceOf(instance).vkDestroyInstance(instance, callbacks);
	const std::unique_lock lock(mutex);
	instances.erase(key);
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* callbacks, VkDevice* device)
{
	const auto* link =
	    takeLink<VkLayerDeviceCreateInfo, VkLayerDeviceLink>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
	const PFN_vkGetDeviceProcAddr get = link->pfnNextGetDeviceProcAddr;
	const auto create = reinterpret_cast<PFN_vkCreateDevice>(
	    link->pfnNextGetInstanceProcAddr(instanceOf(physical).handle, "vkCreateDevice"));
	faults().renew();
	if (const auto fault = faults().next(kAll))
		return *fault;
	VkDeviceCreateInfo asked = *info;
	asked.pNext = withoutGivenFeature(info->pNext);
	const VkResult made = create(physical, &asked, callbacks, device);
	if (made != VK_SUCCESS)
		return made;
	const std::unique_lock lock(mutex);
	NextDevice& next = devices[keyOf(*device)];
	next.handle = *device;
	next.get = get;
#define VP_LOAD(name, bits) next.calls[slot_##name] = get(*device, #name);
	VP_CALLS(VP_LOAD)
#undef VP_LOAD
	next.destroy = reinterpret_cast<PFN_vkDestroyDevice>(get(*device, "vkDestroyDevice"));
	next.free_memory = reinterpret_cast<PFN_vkFreeMemory>(get(*device, "vkFreeMemory"));
	next.buffer_requirements =
	    reinterpret_cast<PFN_vkGetBufferMemoryRequirements>(get(*device, "vkGetBufferMemoryRequirements"));
	next.image_requirements =
	    reinterpret_cast<PFN_vkGetImageMemoryRequirements>(get(*device, "vkGetImageMemoryRequirements"));
	return VK_SUCCESS;
}

VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties* told)
{
	instanceOf(device).vkGetPhysicalDeviceProperties(device, told);
	restrictions().limit(*told);
}

VKAPI_ATTR void VKAPI_CALL properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* told)
{
	instanceOf(device).vkGetPhysicalDeviceProperties2(device, told);
	restrictions().limit(told->properties);
	restrictions().limitChained(told->pNext);
}

VKAPI_ATTR void VKAPI_CALL features(VkPhysicalDevice device, VkPhysicalDeviceFeatures* told)
{
	instanceOf(device).vkGetPhysicalDeviceFeatures(device, told);
	restrictions().limit(*told);
}

VKAPI_ATTR void VKAPI_CALL features2(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* told)
{
	instanceOf(device).vkGetPhysicalDeviceFeatures2(device, told);
	restrictions().limit(told->features);
	addGivenFeature(told->pNext);
}

VKAPI_ATTR void VKAPI_CALL memory(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties* told)
{
	instanceOf(device).vkGetPhysicalDeviceMemoryProperties(device, told);
	restrictions().limit(*told);
}

VKAPI_ATTR void VKAPI_CALL memory2(VkPhysicalDevice device, VkPhysicalDeviceMemoryProperties2* told)
{
	instanceOf(device).vkGetPhysicalDeviceMemoryProperties2(device, told);
	restrictions().limit(told->memoryProperties);
}

VKAPI_ATTR void VKAPI_CALL queueFamilies(VkPhysicalDevice device, std::uint32_t* count, VkQueueFamilyProperties* told)
{
	const auto ask = instanceOf(device).vkGetPhysicalDeviceQueueFamilyProperties;
	std::uint32_t all = 0;
	ask(device, &all, nullptr);
	std::vector<VkQueueFamilyProperties> families(all);
	ask(device, &all, families.data());
	restrictions().limit(families);
	if (told)
		std::copy_n(families.begin(), std::min<std::size_t>(*count, families.size()), told);
	*count = static_cast<std::uint32_t>(told ? std::min<std::size_t>(*count, families.size()) : families.size());
}

VKAPI_ATTR VkResult VKAPI_CALL deviceExtensions(VkPhysicalDevice device, const char* layer, std::uint32_t* count,
                                                VkExtensionProperties* told)
{
	const auto ask = instanceOf(device).vkEnumerateDeviceExtensionProperties;
	std::uint32_t all = 0;
	if (const VkResult asked = ask(device, layer, &all, nullptr); asked != VK_SUCCESS)
		return asked;
	std::vector<VkExtensionProperties> extensions(all);
	if (const VkResult asked = ask(device, layer, &all, extensions.data()); asked != VK_SUCCESS)
		return asked;
	std::erase_if(extensions, [](const auto& extension) { return restrictions().hides(extension.extensionName); });
	if (!layer)
		addGivenExtension(extensions);
	const std::size_t given = told ? std::min<std::size_t>(*count, extensions.size()) : extensions.size();
	if (told)
		std::copy_n(extensions.begin(), given, told);
	*count = static_cast<std::uint32_t>(given);
	return given < extensions.size() ? VK_INCOMPLETE : VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceSupport(VkPhysicalDevice device, std::uint32_t family, VkSurfaceKHR surface,
                                              VkBool32* told)
{
	const VkResult asked = instanceOf(device).vkGetPhysicalDeviceSurfaceSupportKHR(device, family, surface, told);
	if (!restrictions().windows)
		*told = VK_FALSE;
	return asked;
}

PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name);
PFN_vkVoidFunction VKAPI_CALL instanceFunction(VkInstance instance, const char* name);

struct Entry
{
	const char* name;
	PFN_vkVoidFunction function;
};

template <class Function>
Entry entry(const char* name, Function function)
{
	return {name, reinterpret_cast<PFN_vkVoidFunction>(function)};
}

const Entry kInstanceFunctions[] = {
    entry("vkGetInstanceProcAddr", instanceFunction),
    entry("vkCreateInstance", createInstance),
    entry("vkDestroyInstance", destroyInstance),
    entry("vkCreateDevice", createDevice),
    entry("vkGetPhysicalDeviceProperties", properties),
    entry("vkGetPhysicalDeviceProperties2", properties2),
    entry("vkGetPhysicalDeviceFeatures", features),
    entry("vkGetPhysicalDeviceFeatures2", features2),
    entry("vkGetPhysicalDeviceMemoryProperties", memory),
    entry("vkGetPhysicalDeviceMemoryProperties2", memory2),
    entry("vkGetPhysicalDeviceQueueFamilyProperties", queueFamilies),
    entry("vkEnumerateDeviceExtensionProperties", deviceExtensions),
    entry("vkGetPhysicalDeviceSurfaceSupportKHR", surfaceSupport),
};

// The first of a name counts.
const Entry kDeviceFunctions[] = {entry("vkGetDeviceProcAddr", deviceFunction),
                                  entry("vkDestroyDevice", destroyDevice),
                                  entry("vkAllocateMemory", allocateMemory),
                                  entry("vkFreeMemory", freeMemory),
                                  entry("vkGetBufferMemoryRequirements", bufferRequirements),
                                  entry("vkGetImageMemoryRequirements", imageRequirements),
#define VP_ENTRY(name, bits) entry(#name, &Failing<PFN_##name>::call<slot_##name, bits>),
                                  VP_CALLS(VP_ENTRY)
#undef VP_ENTRY
};

const Entry kGivenFunctions[] = {entry("vkGetPipelineExecutablePropertiesKHR", givenExecutables),
                                 entry("vkGetPipelineExecutableStatisticsKHR", givenStatistics)};

template <std::size_t size>
PFN_vkVoidFunction find(const Entry (&entries)[size], const char* name)
{
	const auto* found = std::find_if(std::begin(entries), std::end(entries),
	                                 [&](const Entry& e) { return !std::strcmp(e.name, name); });
	return found == std::end(entries) ? nullptr : found->function;
}

PFN_vkVoidFunction VKAPI_CALL deviceFunction(VkDevice device, const char* name)
{
	const NextDevice& next = deviceOf(device);
	// If the next layer does not have a function, this one does not have it either.
	if (const PFN_vkVoidFunction given = find(kGivenFunctions, name); given && givesExecutables())
		return given;
	const PFN_vkVoidFunction there = next.get(device, name);
	const PFN_vkVoidFunction here = find(kDeviceFunctions, name);
	return there && here ? here : there;
}

PFN_vkVoidFunction VKAPI_CALL instanceFunction(VkInstance instance, const char* name)
{
	if (const PFN_vkVoidFunction here = find(kInstanceFunctions, name))
		return here;
	if (!instance)
		return nullptr;
	const PFN_vkVoidFunction there = instanceOf(instance).get(instance, name);
	const PFN_vkVoidFunction here = find(kDeviceFunctions, name);
	return there && here ? here : there;
}

} // namespace

} // namespace vp::layer

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version)
{
	vp::layer::restrictions();
	vp::layer::faults();
	version->loaderLayerInterfaceVersion = std::min(version->loaderLayerInterfaceVersion, 2u);
	version->pfnGetInstanceProcAddr = vp::layer::instanceFunction;
	version->pfnGetDeviceProcAddr = vp::layer::deviceFunction;
	version->pfnGetPhysicalDeviceProcAddr = nullptr;
	return VK_SUCCESS;
}
