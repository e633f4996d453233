#pragma once

#include "base/result.h"
#include "gpu/vulkan.h"

#include <atomic>
#include <memory>
#include <vector>

namespace vp::gpu
{

// The Vulkan instance with validation, where asked for.
struct Instance
{
	VkInstance handle = VK_NULL_HANDLE;
	VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
	bool debug_utils = false;
	bool validates = false;
	std::atomic<std::size_t> messages = 0; // messages of the validation layer

	Instance() = default;
	~Instance();
	Instance(const Instance&) = delete;
	Instance& operator=(const Instance&) = delete;
};

// Fails in a forked process if an instance of its parent lives: drivers have threads, which are not there.
Result<std::unique_ptr<Instance>> createInstance(bool validation, const std::vector<const char*>& extensions);

// The error in a forked process that would use a device of its parent.
Error forkedError();

} // namespace vp::gpu
