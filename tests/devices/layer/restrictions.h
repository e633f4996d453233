#pragma once

#include <vulkan/vulkan.h>

#include <string>
#include <vector>

namespace vp::layer
{

/// Restricts a device. VPROBE_LAYER_RESTRICT has the names of the restrictions, separated by commas:
///   no-float64         no doubles in shaders
///   small-uniforms     uniform buffers of 16 KiB
///   small-storage      storage buffers of 128 MiB
///   small-texels       texel buffers of 65 536 elements
///   no-timestamps      a queue without timestamps
///   one-queue          one family with one queue
///   split-memory       memory of the device that the host cannot map, and memory of the host
///   few-descriptors    as many descriptors as Vulkan promises
///   few-allocations    32 allocations of memory
///   no-extensions      only the extensions that windows need
///   no-options         no features but those that the program requires
///   no-windows         no pictures presented in windows
struct Restrictions
{
	bool float64 = true;
	bool uniforms = true;
	bool storage = true;
	bool texels = true;
	bool timestamps = true;
	bool queues = true;
	bool mapped_memory = true;
	bool descriptors = true;
	bool allocations = true;
	bool extensions = true;
	bool options = true;
	bool windows = true;

	/// A name that is not known ends the program: a test that restricts nothing would pass.
	static Restrictions fromEnvironment();

	void limit(VkPhysicalDeviceProperties& properties) const;
	void limit(VkPhysicalDeviceFeatures& features) const;
	void limit(VkPhysicalDeviceMemoryProperties& memory) const;
	void limit(std::vector<VkQueueFamilyProperties>& families) const;
	/// Limits a structure in a pNext chain.
	void limitChained(void* chain) const;
	bool hides(const std::string& extension) const;
};

constexpr std::uint32_t kAllocations = 32; // limit of few-allocations

} // namespace vp::layer
