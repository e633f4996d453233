#include "wrapped_grids.h"

#include <vprobe/vulkan.h>

#include <vulkan/vulkan.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <vector>

// A structure of Vulkan has its type given, and the rest is zero.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace face
{

namespace
{

// A device as a program has one, made by nothing of the library's but VulkanNeeds.
class VulkanFace : public testing::Test
{
protected:
	void SetUp() override
	{
		VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
		application.apiVersion = VK_API_VERSION_1_3;
		VkInstanceCreateInfo instance{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
		instance.pApplicationInfo = &application;
		VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
		messenger.messageSeverity =
		    VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
		messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
		messenger.pfnUserCallback = onMessage;
		messenger.pUserData = &messages_;
		const char* layer = "VK_LAYER_KHRONOS_validation";
		const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
		if (validates())
		{
			instance.enabledLayerCount = instance.enabledExtensionCount = 1;
			instance.ppEnabledLayerNames = &layer;
			instance.ppEnabledExtensionNames = &extension;
		}
		std::uint32_t count = 1;
		if (vkCreateInstance(&instance, nullptr, &device_.instance) != VK_SUCCESS ||
		    vkEnumeratePhysicalDevices(device_.instance, &count, &device_.physical) < 0 || count == 0)
			GTEST_SKIP() << "no Vulkan device";
		if (validates())
			reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
			    vkGetInstanceProcAddr(device_.instance, "vkCreateDebugUtilsMessengerEXT"))(device_.instance, &messenger,
			                                                                               nullptr, &messenger_);
		const auto needs = vprobe::VulkanNeeds::of(device_.physical);
		ASSERT_TRUE(needs) << needs.error().message;
		device_.queue_family = needs->queueFamily();
		const float priority = 1.0f;
		VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
		queue.queueFamilyIndex = device_.queue_family;
		queue.queueCount = 1;
		queue.pQueuePriorities = &priority;
		VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, needs->features()};
		info.queueCreateInfoCount = 1;
		info.pQueueCreateInfos = &queue;
		ASSERT_EQ(vkCreateDevice(device_.physical, &info, nullptr, &device_.device), VK_SUCCESS);
		vkGetDeviceQueue(device_.device, device_.queue_family, 0, &device_.queue);
		device_.lock_queue = [this]
		{
			queue_.lock();
			++turns_;
		};
		device_.unlock_queue = [this] { queue_.unlock(); };
		vkGetPhysicalDeviceMemoryProperties(device_.physical, &memory_);
	}

	void TearDown() override
	{
		if (device_.device)
		{
			vkDeviceWaitIdle(device_.device);
			vkDestroyCommandPool(device_.device, pool_, nullptr);
			for (const VkImage image : images_)
				vkDestroyImage(device_.device, image, nullptr);
			for (const VkBuffer buffer : buffers_)
				vkDestroyBuffer(device_.device, buffer, nullptr);
			for (const VkDeviceMemory memory : memories_)
				vkFreeMemory(device_.device, memory, nullptr);
			vkDestroyDevice(device_.device, nullptr);
		}
		if (messenger_)
			reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(vkGetInstanceProcAddr(
			    device_.instance, "vkDestroyDebugUtilsMessengerEXT"))(device_.instance, messenger_, nullptr);
		if (device_.instance)
			vkDestroyInstance(device_.instance, nullptr);
		EXPECT_EQ(messages_, 0);
	}

	VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags flags)
	{
		std::uint32_t type = 0;
		while (!(needs.memoryTypeBits >> type & 1u) || (memory_.memoryTypes[type].propertyFlags & flags) != flags)
			++type;
		const VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, nullptr, needs.size, type};
		EXPECT_EQ(vkAllocateMemory(device_.device, &info, nullptr, &memories_.emplace_back()), VK_SUCCESS);
		return memories_.back();
	}

	vprobe::VulkanTarget target(VkFormat format, std::uint32_t width, std::uint32_t height)
	{
		VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
		info.imageType = VK_IMAGE_TYPE_2D;
		info.format = format;
		info.extent = {width, height, 1};
		info.mipLevels = info.arrayLayers = 1;
		info.samples = VK_SAMPLE_COUNT_1_BIT;
		info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
		images_.emplace_back();
		EXPECT_EQ(vkCreateImage(device_.device, &info, nullptr, &images_.back()), VK_SUCCESS);
		VkMemoryRequirements needs;
		vkGetImageMemoryRequirements(device_.device, images_.back(), &needs);
		EXPECT_EQ(vkBindImageMemory(device_.device, images_.back(), allocate(needs, 0), 0), VK_SUCCESS);
		return {images_.back(), format, width, height, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
	}

	std::vector<std::uint8_t> bytesOf(const vprobe::VulkanTarget& target)
	{
		VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
		info.size = VkDeviceSize(4) * target.width * target.height;
		info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
		VkBuffer& buffer = buffers_.emplace_back();
		EXPECT_EQ(vkCreateBuffer(device_.device, &info, nullptr, &buffer), VK_SUCCESS);
		VkMemoryRequirements needs;
		vkGetBufferMemoryRequirements(device_.device, buffer, &needs);
		const VkDeviceMemory memory =
		    allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
		vkBindBufferMemory(device_.device, buffer, memory, 0);

		if (!pool_)
		{
			const VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr, 0,
			                                   device_.queue_family};
			vkCreateCommandPool(device_.device, &pool, nullptr, &pool_);
		}
		const VkCommandBufferAllocateInfo of{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_,
		                                     VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
		VkCommandBuffer commands = VK_NULL_HANDLE;
		vkAllocateCommandBuffers(device_.device, &of, &commands);
		const VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
		vkBeginCommandBuffer(commands, &begin);
		VkBufferImageCopy region{};
		region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		region.imageExtent = {target.width, target.height, 1};
		vkCmdCopyImageToBuffer(commands, target.image, target.after, buffer, 1, &region);
		vkEndCommandBuffer(commands);
		VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
		submit.commandBufferCount = 1;
		submit.pCommandBuffers = &commands;
		EXPECT_EQ(vkQueueSubmit(device_.queue, 1, &submit, VK_NULL_HANDLE), VK_SUCCESS);
		vkQueueWaitIdle(device_.queue);
		std::vector<std::uint8_t> bytes(info.size);
		void* mapped = nullptr;
		vkMapMemory(device_.device, memory, 0, VK_WHOLE_SIZE, 0, &mapped);
		std::memcpy(bytes.data(), mapped, bytes.size());
		vkUnmapMemory(device_.device, memory);
		return bytes;
	}

	vprobe::VulkanDevice device_;
	int turns_ = 0;

private:
	static bool validates()
	{
		const char* set = std::getenv("VPROBE_VALIDATION");
		return set && std::string_view(set) == "1";
	}
	static VkBool32 VKAPI_PTR onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
	                                    const VkDebugUtilsMessengerCallbackDataEXT* data, void* count)
	{
		std::fprintf(stderr, "%s\n", data->pMessage);
		++*static_cast<int*>(count);
		return VK_FALSE;
	}

	int messages_ = 0;
	VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
	std::mutex queue_;
	VkPhysicalDeviceMemoryProperties memory_{};
	VkCommandPool pool_ = VK_NULL_HANDLE;
	std::vector<VkImage> images_;
	std::vector<VkBuffer> buffers_;
	std::vector<VkDeviceMemory> memories_;
};

} // namespace

// The picture of render(), on another device, in the order of bytes that each format has.
TEST_F(VulkanFace, DrawsIntoTheCallersImages)
{
	const Box box(6);
	const auto data = vprobe::Dataset::wrap({box.unstructured()});
	ASSERT_TRUE(data);
	vprobe::View view = onWhite();
	const auto image = data->render(view.size(200, 120));
	ASSERT_TRUE(image) << image.error().message;

	ASSERT_TRUE(vprobe::useDevice(*data, device_));
	const auto cut = data->cut(view);
	ASSERT_TRUE(cut);
	for (const VkFormat format : {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_B8G8R8A8_UNORM})
	{
		const vprobe::VulkanTarget to = target(format, 200, 120);
		const vprobe::Status drawn = vprobe::drawInto(*data, *cut, view, to);
		ASSERT_TRUE(drawn) << drawn.error().message;
		std::vector<std::uint8_t> bytes = bytesOf(to);
		if (format == VK_FORMAT_B8G8R8A8_UNORM)
			for (std::size_t i = 0; i < bytes.size(); i += 4)
				std::swap(bytes[i], bytes[i + 2]);
		EXPECT_EQ(bytes, image->rgba) << "VkFormat " << format;
	}
	EXPECT_GT(turns_, 3);
}

TEST_F(VulkanFace, ClassifiesOnTheCallersDevice)
{
	const Box box(6);
	const auto by_cpu = vprobe::Dataset::wrap({box.unstructured()}, vprobe::Classify::cpu);
	const auto data = vprobe::Dataset::wrap({box.unstructured()}, vprobe::Classify::gpu);
	ASSERT_TRUE(by_cpu && data);
	const vprobe::View view = onWhite();
	const auto before = data->cut(view); // on a device of its own
	ASSERT_TRUE(before);
	ASSERT_TRUE(vprobe::useDevice(*data, device_));
	const int turns = turns_;
	const auto cut = data->cut(view);
	ASSERT_TRUE(cut) << cut.error().message;
	EXPECT_GT(turns_, turns);
	EXPECT_EQ(cut->figures(0).cut_cells, by_cpu->cut(view)->figures(0).cut_cells);
	// A cut from the device before is drawn all the same, and at any size.
	const vprobe::VulkanTarget small = target(VK_FORMAT_R8G8B8A8_UNORM, 64, 48);
	const vprobe::Status drawn = vprobe::drawInto(*data, *before, view, small);
	ASSERT_TRUE(drawn) << drawn.error().message;
	const std::vector<std::uint8_t> bytes = bytesOf(small);
	EXPECT_NE(std::count(bytes.begin(), bytes.end(), 255), static_cast<std::ptrdiff_t>(bytes.size()));
}

TEST_F(VulkanFace, WhatCannotBeIsAUsageError)
{
	const Box box(4);
	const auto data = vprobe::Dataset::wrap({box.unstructured()});
	ASSERT_TRUE(data);
	const vprobe::View view = onWhite();
	const auto cut = data->cut(view);
	ASSERT_TRUE(cut);
	const auto refused = [&](const vprobe::VulkanTarget& target, const char* part)
	{
		const vprobe::Status drawn = vprobe::drawInto(*data, *cut, view, target);
		ASSERT_FALSE(drawn);
		EXPECT_EQ(drawn.error().kind, vprobe::ErrorKind::usage);
		EXPECT_NE(drawn.error().message.find(part), std::string::npos) << drawn.error().message;
	};
	vprobe::VulkanTarget to = target(VK_FORMAT_R8G8B8A8_UNORM, 64, 48);
	refused(to, "useDevice");
	EXPECT_FALSE(vprobe::useDevice(*data, {}));
	ASSERT_TRUE(vprobe::useDevice(*data, device_));
	to.after = VK_IMAGE_LAYOUT_UNDEFINED;
	refused(to, "layout");
	to = target(VK_FORMAT_R16G16B16A16_SFLOAT, 64, 48);
	refused(to, "VkFormat");
	to = target(VK_FORMAT_R8G8B8A8_UNORM, 64, 48);
	to.width = 0;
	refused(to, "size");
	to.width = 64;
	to.image = VK_NULL_HANDLE;
	refused(to, "image");
	EXPECT_TRUE(data->render(onWhite().size(32, 32))); // goes on
}

} // namespace face
