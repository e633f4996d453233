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

/// With what features a device has to be created for the library to work on it: Vulkan 1.3 with synchronization2,
/// dynamicRendering, maintenance4, timelineSemaphore, scalarBlockLayout and hostQueryReset, and some that are used
/// where there are such. More features and any extension may be enabled too.
class VPROBE_API VulkanNeeds
{
public:
	/// ErrorKind::device where the device lacks something; the message says what.
	static Result<VulkanNeeds> of(VkPhysicalDevice physical);

	/// For VkDeviceCreateInfo::pNext, with pEnabledFeatures null: VkPhysicalDeviceFeatures2, with those of Vulkan 1.2
	/// and 1.3 behind it. Valid as long as this object or a copy of it.
	const VkPhysicalDeviceFeatures2* features() const;
	/// A family of queues for graphics and compute.
	std::uint32_t queueFamily() const { return queue_family_; }

private:
	VulkanNeeds() = default;

	std::shared_ptr<const void> features_;
	std::uint32_t queue_family_ = 0;
};

/// A device of the caller's, created with VulkanNeeds. All handles outlive every Dataset that has the device, and every
/// Cut of theirs.
struct VulkanDevice
{
	VkInstance instance = VK_NULL_HANDLE;
	VkPhysicalDevice physical = VK_NULL_HANDLE;
	VkDevice device = VK_NULL_HANDLE;
	VkQueue queue = VK_NULL_HANDLE; // from a queue family for graphics and compute
	std::uint32_t queue_family = 0;
	/// Called before and after the library uses the queue, from the thread that called it or from one that works for
	/// it. Empty: nobody else uses the queue while a call of the library runs.
	std::function<void()> lock_queue{};
	std::function<void()> unlock_queue{};
};

/// A 2-D image of the caller's: one layer, one level, one sample, made with VK_IMAGE_USAGE_TRANSFER_DST_BIT on the
/// device that the data set has. It belongs to the device's queue family.
struct VulkanTarget
{
	VkImage image = VK_NULL_HANDLE;
	VkFormat format = VK_FORMAT_R8G8B8A8_UNORM; // or R8G8B8A8_SRGB, B8G8R8A8_UNORM: all get the same bytes of sRGB
	std::uint32_t width = 0;                    // 1 to 16384 pixels
	std::uint32_t height = 0;
	VkImageLayout before = VK_IMAGE_LAYOUT_UNDEFINED; // layout of the image before the call; its content is replaced
	VkImageLayout after = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
};

/// From now on the data set classifies and draws on this device, and opens none of its own. ErrorKind::device where the
/// device does not do. Thread safe, as all calls on a data set.
VPROBE_API Status useDevice(const Dataset& data, const VulkanDevice& device);

/// Draws a cut of the data set, made by the same View, over the whole image, which decides the picture's size. Colors
/// are multiplied by alpha. Comes back when the image is ready: later submissions to the queue see it. Work that the
/// caller submitted to the queue before may still use the image. A usage error where the data set has no device of the
/// caller's, or where the image cannot be.
VPROBE_API Status drawInto(const Dataset& data, const Cut& cut, const View& view, const VulkanTarget& target);

} // namespace vprobe
