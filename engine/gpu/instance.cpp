#include "gpu/instance.h"

#include "base/messages.h"
#include "base/timeline.h"
#include "gpu/vk_check.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <new>
#include <string_view>

#include <unistd.h>

namespace vp::gpu
{

namespace
{
constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* instance)
{
	static_cast<Instance*>(instance)->messages.fetch_add(1);
	try
	{
		report(Severity::error, data->pMessage);
	}
	catch (const std::bad_alloc&)
	{
		// The driver that calls this is no C++, and would not pass an error on. The message is counted.
	}
	return VK_FALSE;
}

bool hasLayer(std::string_view name)
{
	std::uint32_t count = 0;
	vkEnumerateInstanceLayerProperties(&count, nullptr);
	std::vector<VkLayerProperties> layers(count);
	vkEnumerateInstanceLayerProperties(&count, layers.data());
	return std::any_of(layers.begin(), layers.end(), [&](const auto& layer) { return name == layer.layerName; });
}

bool hasExtension(std::string_view name)
{
	std::uint32_t count = 0;
	vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
	std::vector<VkExtensionProperties> extensions(count);
	vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
	return std::any_of(extensions.begin(), extensions.end(),
	                   [&](const auto& extension) { return name == extension.extensionName; });
}

// The instances that live, and the process that made them.
struct LiveInstances
{
	std::mutex mutex;
	pid_t process = 0;
	std::size_t count = 0;
};

LiveInstances& liveInstances()
{
	static LiveInstances one;
	return one;
}

} // namespace

Error forkedError()
{
	return {ErrorKind::device, "a forked process cannot use the Vulkan device that its parent opened; start it with "
	                           "multiprocessing.get_context(\"spawn\"), or draw in the parent"};
}

Instance::~Instance()
{
	{
		LiveInstances& live = liveInstances();
		const std::lock_guard lock(live.mutex);
		if (live.process != getpid())
			return; // it belongs to the process that forked this one, whose threads are not here
		if (handle)
			--live.count;
	}
	if (messenger)
		if (const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
		        vkGetInstanceProcAddr(handle, "vkDestroyDebugUtilsMessengerEXT")))
			destroy(handle, messenger, nullptr);
	vkDestroyInstance(handle, nullptr);
}

Result<std::unique_ptr<Instance>> createInstance(bool validation, const std::vector<const char*>& extensions)
{
	const TimedSection section(Timeline::tracingHere(), "Vulkan instance", 0, Timeline::Track::setup);
	{
		LiveInstances& live = liveInstances();
		const std::lock_guard lock(live.mutex);
		if (live.process != getpid() && live.count > 0)
			return forkedError();
		live.process = getpid();
	}
	auto instance = std::make_unique<Instance>();
	if (validation && !hasLayer(kValidationLayer))
		warn("no Vulkan validation: install vulkan-validationlayers");
	instance->validates = validation && hasLayer(kValidationLayer);
	instance->debug_utils = instance->validates || hasExtension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

	std::vector<const char*> enabled = extensions;
	if (instance->debug_utils)
		enabled.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

	VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
	application.pApplicationName = "vprobe";
	application.apiVersion = VK_API_VERSION_1_3;
	const std::array checks{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
	VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
	features.enabledValidationFeatureCount = static_cast<std::uint32_t>(checks.size());
	features.pEnabledValidationFeatures = checks.data();
	VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
	messenger.messageSeverity =
	    VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
	// Without GENERAL: the loader's remarks about other drivers are not about this program.
	messenger.messageType =
	    VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
	messenger.pfnUserCallback = onMessage;
	messenger.pUserData = instance.get();
	// Chained, the messenger hears what creating and destroying the instance has to say too.
	features.pNext = &messenger;

	VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
	info.pApplicationInfo = &application;
	info.enabledExtensionCount = static_cast<std::uint32_t>(enabled.size());
	info.ppEnabledExtensionNames = enabled.data();
	if (instance->validates)
	{
		info.pNext = &features;
		info.enabledLayerCount = 1;
		info.ppEnabledLayerNames = &kValidationLayer;
	}
	if (const VkResult made = vkCreateInstance(&info, nullptr, &instance->handle); made != VK_SUCCESS)
		return Error{ErrorKind::device, fmt::format("Vulkan cannot be used ({}); install mesa-vulkan-drivers, or the "
		                                            "driver of your graphics card",
		                                            resultName(made))};
	{
		LiveInstances& live = liveInstances();
		const std::lock_guard lock(live.mutex);
		++live.count;
	}
	if (instance->validates)
		if (const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
		        vkGetInstanceProcAddr(instance->handle, "vkCreateDebugUtilsMessengerEXT")))
			if (Status made = check(create(instance->handle, &messenger, nullptr, &instance->messenger),
			                        "vkCreateDebugUtilsMessengerEXT");
			    !made)
				return made.error();
	return instance;
}

} // namespace vp::gpu
