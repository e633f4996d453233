#include "gpu/vk_check.h"
#include "viewer/screen/gpu_screen.h"

#include <algorithm>

namespace vp::app
{

namespace
{

constexpr VkImageUsageFlags kTargetUsage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

} // namespace

// This file sets up the parts of a screen: formats, frames, and the images that frames are drawn into.

Status Screen::chooseWay()
{
	VkBool32 presents = VK_FALSE;
	vkGetPhysicalDeviceSurfaceSupportKHR(device_.physical(), device_.queueFamily(), surface_, &presents);
	if (presents && !RowSender::isRemote())
		return Nothing{};
	auto rows = RowSender::create(window_.handle());
	if (rows)
		rows_ = std::move(*rows);
	else if (!presents)
		return Error{ErrorKind::device,
		             device_.name() + " cannot show pictures in this window; name another one with --device"};
	return Nothing{};
}

// Takes eight bits per channel without conversion, since pictures are sRGB already.
Status Screen::chooseFormat()
{
	if (rows_)
	{
		format_.format = VK_FORMAT_B8G8R8A8_UNORM;
		return Nothing{};
	}
	std::uint32_t count = 0;
	vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr);
	std::vector<VkSurfaceFormatKHR> formats(count);
	vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, formats.data());
	const auto fits = [](const VkSurfaceFormatKHR& format)
	{ return format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM; };
	const auto found = std::ranges::find_if(formats, fits);
	if (found == formats.end())
		return Error{ErrorKind::device, "the window takes no picture of eight bits a channel; draw with vprobe render"};
	format_ = *found;
	return Nothing{};
}

// ImGui of Debian 12 supports only render passes. ImGui draws over the pictures.
Status Screen::makeRenderPass()
{
	VkAttachmentDescription color{};
	color.format = format_.format;
	color.samples = VK_SAMPLE_COUNT_1_BIT;
	color.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
	color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
	color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
	color.initialLayout = color.finalLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	const VkAttachmentReference target{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
	VkSubpassDescription pass{};
	pass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
	pass.colorAttachmentCount = 1;
	pass.pColorAttachments = &target;
	VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
	info.attachmentCount = 1;
	info.pAttachments = &color;
	info.subpassCount = 1;
	info.pSubpasses = &pass;
	if (Status made =
	        gpu::check(vkCreateRenderPass(device_.handle(), &info, nullptr, &render_pass_), "vkCreateRenderPass");
	    !made)
		return made;
	const VkDescriptorPoolSize fonts{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 4};
	VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
	pool.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
	pool.maxSets = 4;
	pool.poolSizeCount = 1;
	pool.pPoolSizes = &fonts;
	return gpu::check(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &descriptors_),
	                  "vkCreateDescriptorPool");
}

Status Screen::makeFrames()
{
	for (Frame& frame : frames_)
	{
		Result<gpu::Commands> commands = gpu::Commands::create(device_, "frame");
		if (!commands)
			return commands.error();
		frame.commands = std::move(*commands);
		const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
		if (Status made = gpu::check(vkCreateSemaphore(device_.handle(), &semaphore, nullptr, &frame.acquired),
		                             "vkCreateSemaphore");
		    !made)
			return made;
	}
	return Nothing{};
}

Status Screen::makeTargets(VkExtent2D extent)
{
	return rows_ ? makeOwnTarget(extent) : makeSwapchain(extent);
}

Status Screen::makeOwnTarget(VkExtent2D extent)
{
	if (extent.width == 0 || extent.height == 0)
		return Nothing{}; // minimized: later
	if (Status idle = device_.waitIdle(); !idle)
		return idle;
	dropTargets();
	auto made = gpu::Image::create(device_, {extent, format_.format, kTargetUsage}, "window");
	if (!made)
		return made.error();
	auto pixels = gpu::Buffer::create(device_, VkDeviceSize(4) * extent.width * extent.height,
	                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::readback, "rows of the window");
	if (!pixels)
		return pixels.error();
	own_ = std::move(*made);
	own_pixels_ = std::move(*pixels);
	extent_ = extent;
	fits_ = true;
	return addTarget(own_.handle());
}

Status Screen::makeSwapchain(VkExtent2D extent)
{
	VkSurfaceCapabilitiesKHR can{};
	if (Status asked = gpu::check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &can),
	                              "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
	    !asked)
		return asked;
	if (can.currentExtent.width != ~0u)
		extent = can.currentExtent;
	if (extent.width == 0 || extent.height == 0)
		return Nothing{}; // minimized: later
	if (Status idle = device_.waitIdle(); !idle)
		return idle;
	VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
	info.surface = surface_;
	info.minImageCount = std::max(can.minImageCount, static_cast<std::uint32_t>(kFramesInFlight) + 1);
	if (can.maxImageCount > 0)
		info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
	info.imageFormat = format_.format;
	info.imageColorSpace = format_.colorSpace;
	info.imageExtent = extent;
	info.imageArrayLayers = 1;
	info.imageUsage = kTargetUsage;
	info.preTransform = can.currentTransform;
	info.compositeAlpha = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR)
	                          ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
	                          : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
	info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
	info.clipped = VK_TRUE;
	info.oldSwapchain = swapchain_;
	VkSwapchainKHR made = VK_NULL_HANDLE;
	const Status created =
	    gpu::check(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made), "vkCreateSwapchainKHR");
	dropTargets();
	vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
	swapchain_ = made;
	if (!created)
		return created;
	extent_ = extent;
	fits_ = true;
	std::uint32_t count = 0;
	vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr);
	std::vector<VkImage> images(count);
	vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images.data());
	for (const VkImage image : images)
		if (Status added = addTarget(image); !added)
			return added;
	return Nothing{};
}

Status Screen::addTarget(VkImage image)
{
	Target& target = targets_.emplace_back();
	target.image = image;
	VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
	view.image = image;
	view.viewType = VK_IMAGE_VIEW_TYPE_2D;
	view.format = format_.format;
	view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
	if (Status made =
	        gpu::check(vkCreateImageView(device_.handle(), &view, nullptr, &target.view), "vkCreateImageView");
	    !made)
		return made;
	VkFramebufferCreateInfo framebuffer{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
	framebuffer.renderPass = render_pass_;
	framebuffer.attachmentCount = 1;
	framebuffer.pAttachments = &target.view;
	framebuffer.width = extent_.width;
	framebuffer.height = extent_.height;
	framebuffer.layers = 1;
	if (Status made = gpu::check(vkCreateFramebuffer(device_.handle(), &framebuffer, nullptr, &target.framebuffer),
	                             "vkCreateFramebuffer");
	    !made)
		return made;
	const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
	return gpu::check(vkCreateSemaphore(device_.handle(), &semaphore, nullptr, &target.drawn), "vkCreateSemaphore");
}

void Screen::dropTargets()
{
	for (const Target& target : targets_)
	{
		vkDestroyFramebuffer(device_.handle(), target.framebuffer, nullptr);
		vkDestroyImageView(device_.handle(), target.view, nullptr);
		vkDestroySemaphore(device_.handle(), target.drawn, nullptr);
	}
	targets_.clear();
}

} // namespace vp::app
