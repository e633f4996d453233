#include "gpu/device.h"

#include "base/timeline.h"
#include "gpu/device_choice.h"
#include "gpu/device_private.h"
#include "gpu/pipeline_figures.h"
#include "gpu/vk_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace vp::gpu
{

namespace
{
bool validationWanted(const DeviceOptions& options)
{
	const char* set = std::getenv("VPROBE_VALIDATION");
	return options.validation.value_or(set && *set && std::string_view(set) != "0");
}

// CLOCK_MONOTONIC, which is the steady clock on Linux.
bool calibratesToSteadyClock(VkInstance instance, VkPhysicalDevice device)
{
	const auto domains_of = reinterpret_cast<PFN_vkGetPhysicalDeviceCalibrateableTimeDomainsEXT>(
	    vkGetInstanceProcAddr(instance, "vkGetPhysicalDeviceCalibrateableTimeDomainsEXT"));
	if (!domains_of)
		return false;
	std::uint32_t count = 0;
	domains_of(device, &count, nullptr);
	std::vector<VkTimeDomainEXT> domains(count);
	domains_of(device, &count, domains.data());
	const auto has = [&](VkTimeDomainEXT domain)
	{ return std::find(domains.begin(), domains.end(), domain) != domains.end(); };
	return has(VK_TIME_DOMAIN_DEVICE_EXT) && has(VK_TIME_DOMAIN_CLOCK_MONOTONIC_EXT);
}

// Only a profile counts, so a device of the caller need not have the feature.
VkBool32 canCountInvocations(VkPhysicalDevice device)
{
	VkPhysicalDeviceFeatures present;
	vkGetPhysicalDeviceFeatures(device, &present);
	return present.pipelineStatisticsQuery;
}

// Returns the feature as it is to be enabled.
VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR figuresOfPipelines(const Candidate& device)
{
	VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR told{
	    VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR};
	if (!keepsPipelineFigures() || !device.has(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME))
		return told;
	VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &told};
	vkGetPhysicalDeviceFeatures2(device.handle, &features);
	told.pNext = nullptr;
	return told;
}

template <class Function>
void load(Function& function, VkDevice device, const char* name)
{
	function = reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
}

// Returns true if the kernel has a file for a graphics device. This takes a moment, while loading the drivers takes
// tens of milliseconds. On systems other than Linux the drivers must be asked.
bool mayHaveHardware()
{
#ifdef __linux__
	constexpr std::array kNodes{"/dev/dri", "/dev/nvidiactl", "/dev/dxg", "/dev/kgsl-3d0", "/dev/mali0"};
	return std::ranges::any_of(kNodes,
	                           [](const char* node)
	                           {
		                           std::error_code error;
		                           return std::filesystem::exists(node, error);
	                           });
#else
	return true;
#endif
}

} // namespace

Device::Device() : private_(std::make_unique<Private>()), process_(getpid()) {}

bool Device::isInherited() const
{
	return process_ != getpid();
}

Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options)
{
	const Error no_hardware{ErrorKind::device, "no Vulkan device but software on the CPU"};
	if (options.hardware_only && !mayHaveHardware())
		return no_hardware;
	std::unique_ptr<Device> device(new Device);
	Private& hidden = *device->private_;
	Result<std::unique_ptr<Instance>> instance = createInstance(validationWanted(options), options.instance_extensions);
	if (!instance)
		return instance.error();
	hidden.instance = std::move(*instance);
	device->instance_ = hidden.instance->handle;
	Result<Candidate> choice = chooseDevice(device->instance_, options);
	if (!choice)
		return choice.error();
	if (options.hardware_only && choice->type == VK_PHYSICAL_DEVICE_TYPE_CPU)
		return no_hardware;
	device->memory_asked_ = options.memory;
	device->examined(*choice);

	std::vector<const char*> extensions;
	if (options.swapchain)
		extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
	if (hidden.has_memory_budget)
		extensions.push_back(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
	const bool calibrates = choice->has(VK_EXT_CALIBRATED_TIMESTAMPS_EXTENSION_NAME) &&
	                        calibratesToSteadyClock(device->instance_, device->physical_);
	if (calibrates)
		extensions.push_back(VK_EXT_CALIBRATED_TIMESTAMPS_EXTENSION_NAME);

	const WantedFeatures features(device->physical_);
	VkPhysicalDeviceFeatures2 enabled = features.all();
	enabled.features.pipelineStatisticsQuery = canCountInvocations(device->physical_);
	device->features_ = enabled.features;
	VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR figures = figuresOfPipelines(*choice);
	figures.pNext = &enabled;
	if (figures.pipelineExecutableInfo)
		extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
	const float priority = 1.0f;
	VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
	queue.queueFamilyIndex = device->queue_family_;
	queue.queueCount = 1;
	queue.pQueuePriorities = &priority;
	VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, figures.pNext};
	if (figures.pipelineExecutableInfo)
		info.pNext = &figures;
	info.queueCreateInfoCount = 1;
	info.pQueueCreateInfos = &queue;
	info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
	info.ppEnabledExtensionNames = extensions.data();
	const VkResult made = [&]
	{
		const TimedSection section(Timeline::tracingHere(), "Vulkan device", 0, Timeline::Track::setup);
		return vkCreateDevice(device->physical_, &info, nullptr, &device->device_);
	}();
	if (made != VK_SUCCESS)
		return Error{ErrorKind::device, fmt::format("device {} cannot be used ({}); another one may do: `device`",
		                                            device->name_, resultName(made))};
	vkGetDeviceQueue(device->device_, device->queue_family_, 0, &device->queue_);
	if (hidden.instance->debug_utils)
	{
		load(hidden.set_name, device->device_, "vkSetDebugUtilsObjectNameEXT");
		load(hidden.begin_label, device->device_, "vkCmdBeginDebugUtilsLabelEXT");
		load(hidden.end_label, device->device_, "vkCmdEndDebugUtilsLabelEXT");
	}
	if (calibrates)
		load(hidden.calibrated_timestamps, device->device_, "vkGetCalibratedTimestampsEXT");

	device->owned_ = true;
	if (Status ready = device->getReady(options.map_device_memory); !ready)
		return ready.error();
	return device;
}

Result<std::unique_ptr<Device>> Device::adopt(AdoptedDevice adopted)
{
	Candidate candidate = examine(adopted.physical, false);
	if (!candidate.lacks.empty())
		return unusable(candidate);
	candidate.queue_family = adopted.queue_family;
	std::unique_ptr<Device> device(new Device);
	device->instance_ = adopted.instance;
	device->examined(candidate);
	device->features_ = WantedFeatures(adopted.physical).all().features;
	device->device_ = adopted.device;
	device->queue_ = adopted.queue;
	device->private_->lock_queue = std::move(adopted.lock_queue);
	device->private_->unlock_queue = std::move(adopted.unlock_queue);
	if (Status ready = device->getReady(true); !ready)
		return ready.error();
	return device;
}

void Device::examined(const Candidate& candidate)
{
	physical_ = candidate.handle;
	name_ = candidate.name;
	type_ = candidate.type;
	queue_family_ = candidate.queue_family;

	VkPhysicalDeviceMaintenance4Properties maintenance4{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
	VkPhysicalDeviceFloatControlsProperties floats{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FLOAT_CONTROLS_PROPERTIES,
	                                               &maintenance4};
	VkPhysicalDeviceMaintenance3Properties maintenance3{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES,
	                                                    &floats};
	VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &maintenance3};
	vkGetPhysicalDeviceProperties2(physical_, &properties);
	limits_ = properties.properties.limits;
	max_buffer_size_ = std::min(maintenance4.maxBufferSize, maintenance3.maxMemoryAllocationSize);
	VkPhysicalDeviceFeatures features;
	vkGetPhysicalDeviceFeatures(physical_, &features);
	has_exact_doubles_ = features.shaderFloat64 && floats.shaderRoundingModeRTEFloat64;
	vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
	VkDeviceSize largest = 0;
	for (std::uint32_t i = 0; i < memory_.memoryHeapCount; ++i)
		if (memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
			largest = std::max(largest, memory_.memoryHeaps[i].size);
	memory_budget_ = memory_asked_ > 0 ? std::min(memory_asked_, largest) : largest / 2;
	private_->has_memory_budget = candidate.has(VK_EXT_MEMORY_BUDGET_EXTENSION_NAME);
	std::uint32_t families = 0;
	vkGetPhysicalDeviceQueueFamilyProperties(physical_, &families, nullptr);
	std::vector<VkQueueFamilyProperties> family(families);
	vkGetPhysicalDeviceQueueFamilyProperties(physical_, &families, family.data());
	timestamp_bits_ = family[queue_family_].timestampValidBits;
}

Status Device::getReady(bool map_device_memory)
{
	private_->arena = std::make_unique<Arena>(device_, Arena::Needs{memory_, limits_, map_device_memory});
	VkSemaphoreTypeCreateInfo timeline{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
	timeline.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
	const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &timeline, 0};
	if (Status made = check(vkCreateSemaphore(device_, &semaphore, nullptr, &timeline_), "vkCreateSemaphore"); !made)
		return made;
	const VkPipelineCacheCreateInfo cache{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
	if (Status made = check(vkCreatePipelineCache(device_, &cache, nullptr, &pipeline_cache_), "vkCreatePipelineCache");
	    !made)
		return made;
	setName(VK_OBJECT_TYPE_QUEUE, queue_, "queue");
	setName(VK_OBJECT_TYPE_SEMAPHORE, timeline_, "submissions");
	setName(VK_OBJECT_TYPE_PIPELINE_CACHE, pipeline_cache_, "pipelines");
	return Nothing{};
}

Device::~Device()
{
	if (!device_)
		return;
	if (isInherited())
	{
		static_cast<void>(private_.release()); // all of it is the parent's
		return;
	}
	// A lost device is idle too. The caller may submit to a device that is not ours.
	if (owned_)
		patiently([this] { return vkDeviceWaitIdle(device_); });
	else if (timeline_)
		static_cast<void>(wait(private_->submitted)); // fails where the device is lost, and then all is done
	for (const Private::Retired& retired : private_->retired)
		retired.destroy(device_);
	private_->arena.reset();
	vkDestroyPipelineCache(device_, pipeline_cache_, nullptr);
	vkDestroySemaphore(device_, timeline_, nullptr);
	if (owned_)
		vkDestroyDevice(device_, nullptr);
}

VkDeviceSize Device::memoryLeft() const
{
	VkPhysicalDeviceMemoryBudgetPropertiesEXT budget{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_BUDGET_PROPERTIES_EXT};
	VkPhysicalDeviceMemoryProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MEMORY_PROPERTIES_2};
	if (private_->has_memory_budget)
		properties.pNext = &budget;
	vkGetPhysicalDeviceMemoryProperties2(physical_, &properties);
	VkDeviceSize most = 0;
	for (std::uint32_t i = 0; i < memory_.memoryHeapCount; ++i)
	{
		if (!(memory_.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT))
			continue;
		VkDeviceSize left = memory_.memoryHeaps[i].size;
		if (private_->has_memory_budget)
			left =
			    budget.heapBudget[i] - std::min(budget.heapBudget[i], budget.heapUsage[i]) + private_->arena->freeIn(i);
		most = std::max(most, left);
	}
	if (memory_asked_ > 0)
		most = std::min(most, memory_asked_ - std::min(memory_asked_, memoryUse().used));
	return most;
}

Arena& Device::arena()
{
	return *private_->arena;
}

MemoryUse Device::memoryUse() const
{
	return private_->arena->use();
}

void Device::setName(VkObjectType type, std::uint64_t object, std::string_view name) const
{
	if (!private_->set_name)
		return;
	const std::string text(name);
	const VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT, nullptr, type, object,
	                                         text.c_str()};
	private_->set_name(device_, &info); // names are for debuggers; nothing depends on them
}

void Device::beginLabel(VkCommandBuffer commands, const char* label) const
{
	if (!private_->begin_label)
		return;
	const VkDebugUtilsLabelEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, nullptr, label, {}};
	private_->begin_label(commands, &info);
}

void Device::endLabel(VkCommandBuffer commands) const
{
	if (private_->end_label)
		private_->end_label(commands);
}

bool Device::validates() const
{
	return private_->instance && private_->instance->validates;
}

std::size_t Device::validationMessages() const
{
	return private_->instance ? private_->instance->messages.load() : 0;
}

bool Device::calibrate(std::uint64_t& gpu_ticks, std::uint64_t& steady_ns) const
{
	if (!private_->calibrated_timestamps)
		return false;
	const VkCalibratedTimestampInfoEXT infos[]{
	    {VK_STRUCTURE_TYPE_CALIBRATED_TIMESTAMP_INFO_EXT, nullptr, VK_TIME_DOMAIN_DEVICE_EXT},
	    {VK_STRUCTURE_TYPE_CALIBRATED_TIMESTAMP_INFO_EXT, nullptr, VK_TIME_DOMAIN_CLOCK_MONOTONIC_EXT}};
	std::uint64_t times[2];
	std::uint64_t deviation = 0;
	if (private_->calibrated_timestamps(device_, 2, infos, times, &deviation) != VK_SUCCESS)
		return false;
	gpu_ticks = times[0];
	steady_ns = times[1];
	return true;
}

} // namespace vp::gpu
