#pragma once

#include "base/result.h"
#include "gpu/memory.h"
#include "gpu/vulkan.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vp::gpu
{

struct Candidate; // device_choice.h

struct DeviceOptions
{
	std::string name_or_index;                    // part of a device's name, or its index; empty takes the best one
	std::optional<bool> validation;               // if unset, VPROBE_VALIDATION=1 turns it on
	std::vector<const char*> instance_extensions; // those that a window needs; empty without a window
	bool swapchain = false;
	std::string avoid;             // the name of a device that is taken only if there is no other
	bool hardware_only = false;    // refuse software devices, which run on the CPU
	bool map_device_memory = true; // false: device memory is filled by copies even where it could be written directly
	VkDeviceSize memory = 0;       // bytes of the device that may be used; 0: half of what it has
};

// A device of the caller, created with WantedFeatures (device_choice.h), and one of its queues for graphics and
// compute.
struct AdoptedDevice
{
	VkInstance instance = VK_NULL_HANDLE;
	VkPhysicalDevice physical = VK_NULL_HANDLE;
	VkDevice device = VK_NULL_HANDLE;
	VkQueue queue = VK_NULL_HANDLE;
	std::uint32_t queue_family = 0;
	std::function<void()> lock_queue; // called before every use of the queue; may be empty
	std::function<void()> unlock_queue;
};

// Work for the queue. The semaphores are binary ones, as a swapchain needs them.
struct Submission
{
	std::span<const VkCommandBuffer> commands;
	std::span<const VkSemaphore> wait;
	std::span<const VkSemaphore> signal;
};

// The device to work on with its one queue (graphics and compute). Thread safe. Outlives everything made from it.
//
// Every submission gets the next number of one timeline semaphore. What is destroyed while a submission may still use
// it is kept until the semaphore has passed, so a destructor may run at any time after the submission.
class Device
{
public:
	// No loader, no device or a device that lacks something: ErrorKind::device, with a line that says what to
	// install. A name or index that matches nothing lists what there is.
	static Result<std::unique_ptr<Device>> create(const DeviceOptions& options);
	// Works with a device that belongs to the caller and outlives this object. Returns ErrorKind::device if the device
	// lacks something.
	static Result<std::unique_ptr<Device>> adopt(AdoptedDevice adopted);
	~Device(); // waits for all submissions
	Device(const Device&) = delete;
	Device& operator=(const Device&) = delete;

	// Returns true in a process that was forked from the one that opened the device. There is nothing to draw with.
	bool isInherited() const;

	const std::string& name() const { return name_; }
	bool isSoftware() const { return type_ == VK_PHYSICAL_DEVICE_TYPE_CPU; }
	const VkPhysicalDeviceLimits& limits() const { return limits_; }
	const VkPhysicalDeviceFeatures& features() const
	{
		return features_;
	} // the enabled features; optional ones may be off
	// Doubles that are rounded as those of the CPU are. Vulkan alone lets a device round either way.
	bool hasExactDoubles() const { return has_exact_doubles_; }
	VkDeviceSize maxBufferSize() const { return max_buffer_size_; } // limit of one buffer and its allocation
	// On the largest device-local heap, as far as the driver tells, and of what may be used.
	VkDeviceSize memoryLeft() const;
	VkDeviceSize memoryBudget() const { return memory_budget_; } // that pictures keep to, with their polygons

	VkInstance instance() const { return instance_; }
	VkPhysicalDevice physical() const { return physical_; }
	VkDevice handle() const { return device_; }
	VkQueue queue() const { return queue_; } // for libraries that ask for one; what is submitted goes through submit()
	std::uint32_t queueFamily() const { return queue_family_; }
	const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
	Arena& arena(); // all memory of buffers and images
	MemoryUse memoryUse() const;
	VkPipelineCache pipelineCache() const { return pipeline_cache_; }

	// Returns the number to wait for. Host writes made before are visible to the submission.
	Result<std::uint64_t> submit(const Submission& submission);
	// Spins about 100 us, since most submissions of a traversal end sooner than a thread wakes up; then sleeps.
	Status wait(std::uint64_t number);
	bool isDone(std::uint64_t number) const;
	std::uint64_t lastSubmission() const;
	Status waitIdle();
	VkResult present(const VkPresentInfoKHR& info);
	// Runs `use` while nobody else uses the queue, for libraries that submit by themselves.
	void lendQueue(const std::function<void()>& use);

	// Runs `destroy` as soon as everything submitted so far is done. Destructors call this: without memory to note it,
	// it waits.
	template <class Destroy>
	void retire(const Destroy& destroy) noexcept
	{
		try
		{
			retireLater(destroy);
		}
		catch (const std::bad_alloc&)
		{
			waitForAll();
			destroy(device_);
			return;
		}
		destroyRetired();
	}

	// Names and labels show in debuggers and validation messages; without the debug extension they do nothing.
	void setName(VkObjectType type, std::uint64_t object, std::string_view name) const;
	template <class Handle>
	void setName(VkObjectType type, Handle object, std::string_view name) const
	{
		setName(type, reinterpret_cast<std::uint64_t>(object), name);
	}
	void beginLabel(VkCommandBuffer commands, const char* label) const;
	void endLabel(VkCommandBuffer commands) const;

	bool validates() const;
	std::size_t validationMessages() const; // warnings and errors of the validation layer so far

	// GPU clock: 0 valid bits where the queue has no timestamps.
	std::uint32_t timestampBits() const { return timestamp_bits_; }
	// The GPU's and the steady clock's time at one moment (ticks, ns); false where the driver cannot tell.
	bool calibrate(std::uint64_t& gpu_ticks, std::uint64_t& steady_ns) const;

private:
	struct Private;
	Device();
	void examined(const Candidate& candidate); // stores the properties of a candidate
	Status getReady(bool map_device_memory);   // call this once device_ and queue_ are set
	void retireLater(std::function<void(VkDevice)> destroy);
	void destroyRetired();
	void waitForAll() const;
	VkResult counted(std::uint64_t& number) const;

	std::unique_ptr<Private> private_;
	int process_; // that opened the device
	std::string name_;
	VkPhysicalDeviceType type_ = VK_PHYSICAL_DEVICE_TYPE_OTHER;
	VkPhysicalDeviceLimits limits_{};
	VkPhysicalDeviceFeatures features_{};
	VkPhysicalDeviceMemoryProperties memory_{};
	VkDeviceSize max_buffer_size_ = 0;
	VkDeviceSize memory_asked_ = 0; // DeviceOptions::memory
	VkDeviceSize memory_budget_ = 0;
	bool has_exact_doubles_ = false;
	std::uint32_t queue_family_ = 0;
	std::uint32_t timestamp_bits_ = 0;
	VkInstance instance_ = VK_NULL_HANDLE;
	VkPhysicalDevice physical_ = VK_NULL_HANDLE;
	VkDevice device_ = VK_NULL_HANDLE;
	bool owned_ = false;
	VkQueue queue_ = VK_NULL_HANDLE;
	VkSemaphore timeline_ = VK_NULL_HANDLE;
	VkPipelineCache pipeline_cache_ = VK_NULL_HANDLE;
};

// A label around the commands recorded during its life.
class Label
{
public:
	Label(const Device& device, VkCommandBuffer commands, const char* text) : device_(device), commands_(commands)
	{
		device_.beginLabel(commands_, text);
	}
	~Label() { device_.endLabel(commands_); }
	Label(const Label&) = delete;
	Label& operator=(const Label&) = delete;

private:
	const Device& device_;
	VkCommandBuffer commands_;
};

} // namespace vp::gpu
