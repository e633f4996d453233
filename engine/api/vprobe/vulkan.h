#pragma once

#include <vprobe/dataset.h>

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <memory>

/// For a program that draws with Vulkan itself: the library works on the program's device and draws into its images.
/// The program links the Vulkan loader (libvulkan.so.1), as the library does.

namespace vprobe
{

/// The features with which a device must be created, so that the library can work on it: Vulkan 1.3 with
/// synchronization2, dynamicRendering, maintenance4, timelineSemaphore, scalarBlockLayout and hostQueryReset, and some
/// more that are used if the device has them. More features and any extension may be enabled too.
class VPROBE_API VulkanNeeds
{
public:
	/// Returns ErrorKind::device if the device lacks something; the message says what.
	static Result<VulkanNeeds> of(VkPhysicalDevice physical);

	/// Returns the chain for VkDeviceCreateInfo::pNext, with pEnabledFeatures null: VkPhysicalDeviceFeatures2, then the
	/// features of Vulkan 1.2 and 1.3. It stays valid as long as this object or a copy of it lives.
	const VkPhysicalDeviceFeatures2* features() const;
	/// Returns a queue family for graphics and compute.
	std::uint32_t queueFamily() const { return queue_family_; }

private:
	VulkanNeeds() = default;

	std::shared_ptr<const void> features_;
	std::uint32_t queue_family_ = 0;
};

/// The caller's device, created with VulkanNeeds. All handles must outlive every Dataset that uses the device, and
/// every Cut of these.
struct VulkanDevice
{
	VkInstance instance = VK_NULL_HANDLE;
	VkPhysicalDevice physical = VK_NULL_HANDLE;
	VkDevice device = VK_NULL_HANDLE;
	VkQueue queue = VK_NULL_HANDLE; // from a queue family for graphics and compute
	std::uint32_t queue_family = 0;
	/// The library calls these before and after it uses the queue, from the calling thread or from one of its own
	/// threads. If they are empty, nobody else may use the queue while a call of the library runs.
	std::function<void()> lock_queue{};
	std::function<void()> unlock_queue{};
};

/// The caller's 2-D image: one layer, one level, one sample, created with VK_IMAGE_USAGE_TRANSFER_DST_BIT on the data
/// set's device. It belongs to the device's queue family.
struct VulkanTarget
{
	VkImage image = VK_NULL_HANDLE;
	VkFormat format = VK_FORMAT_R8G8B8A8_UNORM; // or R8G8B8A8_SRGB, B8G8R8A8_UNORM: all get the same bytes of sRGB
	std::uint32_t width = 0;                    // 1 to 16384 pixels
	std::uint32_t height = 0;
	VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED; // layout of the image before the call; its content is replaced
	VkImageLayout after = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
};

/// From now on the data set classifies and draws on this device, and opens none of its own. Returns ErrorKind::device
/// if the device is not good enough. It is thread safe, as all calls on a data set are.
VPROBE_API Status useDevice(const Dataset& data, const VulkanDevice& device);

/// Draws a cut of the data set, made by the same View, over the whole image, which decides the picture's size. Colors
/// are multiplied by alpha. Returns when the image is ready: later submissions to the queue see it. Work that the
/// caller submitted to the queue before may still use the image. Returns a usage error if the data set does not use a
/// device of the caller's, or if the image is not possible.
VPROBE_API Status drawInto(const Dataset& data, const Cut& cut, const View& view, const VulkanTarget& target);

} // namespace vprobe
