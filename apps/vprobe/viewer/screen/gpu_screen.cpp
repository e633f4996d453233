#include "viewer/screen/gpu_screen.h"

#include "gpu/buffer.h"
#include "gpu/vk_check.h"

#include <glm/common.hpp>
#include <imgui/backends/imgui_impl_vulkan.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <utility>

namespace vp::app
{

namespace
{

// Some window systems give no image while a window is hidden, or late when the machine is busy. The window goes on
// hearing its user meanwhile.
constexpr std::uint64_t kWaitsForImage = 100'000'000; // nanoseconds

VkOffset3D corner(const glm::ivec2& at, int depth)
{
	return {at.x, at.y, depth};
}

// Dear ImGui continues with invalid handles after a Vulkan call has failed. This exception ends its work.
struct InterfaceFault
{
	Error error;
};

void endOnFault(VkResult result)
{
	if (const Status done = gpu::check(result, "a call of the user interface"); !done)
		throw InterfaceFault{done.error()};
}

template <class Work>
Status guarded(const Work& work)
{
	try
	{
		return work();
	}
	catch (const InterfaceFault& fault)
	{
		return fault.error;
	}
}

// Dear ImGui 1.90 uploads fonts by itself, 1.90.4 takes the render pass with the rest.
void beginInterface(ImGui_ImplVulkan_InitInfo& info, VkRenderPass pass)
{
#if IMGUI_VERSION_NUM >= 19040
	info.RenderPass = pass;
	ImGui_ImplVulkan_Init(&info);
#else
	ImGui_ImplVulkan_Init(&info, pass);
#endif
}

Status uploadFonts(gpu::Device& device)
{
#if IMGUI_VERSION_NUM >= 19000
	bool made = false;
	device.lendQueue([&] { made = ImGui_ImplVulkan_CreateFontsTexture(); });
	if (!made)
		return Error{ErrorKind::out_of_memory,
		             "the fonts of the window do not fit into device memory; close other programs"};
	return Nothing{};
#else
	Status uploaded =
	    gpu::runOnce(device, "fonts", [](VkCommandBuffer to) { ImGui_ImplVulkan_CreateFontsTexture(to); });
	if (uploaded)
		ImGui_ImplVulkan_DestroyFontUploadObjects();
	return uploaded;
#endif
}

} // namespace

Result<std::unique_ptr<Screen>> Screen::create(gpu::Device& device, const Window& window)
{
	const auto surface = window.makeSurface(device.instance());
	if (!surface)
		return surface.error();
	std::unique_ptr<Screen> screen(new Screen(device, window, *surface));
	for (const auto step : {&Screen::chooseWay, &Screen::chooseFormat, &Screen::makeRenderPass, &Screen::makeFrames})
		if (Status done = (screen.get()->*step)(); !done)
			return done.error();
	if (Status made = screen->makeTargets(window.pixels()); !made)
		return made.error();
	if (Status started = screen->takeFonts(); !started)
		return started.error();
	return screen;
}

Screen::~Screen()
{
	[[maybe_unused]] const Status idle = device_.waitIdle(); // a lost device is idle too
	if (interface_started_)
		ImGui_ImplVulkan_Shutdown();
	dropTargets();
	const VkDevice device = device_.handle();
	vkDestroySwapchainKHR(device, swapchain_, nullptr);
	for (Frame& frame : frames_)
	{
		vkDestroySemaphore(device, frame.acquired, nullptr);
		frame = {};
	}
	vkDestroyDescriptorPool(device, descriptors_, nullptr);
	vkDestroyRenderPass(device, render_pass_, nullptr);
	vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
}

// The backend takes fonts only once, so new fonts need a new backend.
Status Screen::takeFonts()
{
	if (Status idle = device_.waitIdle(); !idle)
		return idle;
	if (interface_started_)
		ImGui_ImplVulkan_Shutdown();
	ImGui_ImplVulkan_InitInfo info{};
	info.Instance = device_.instance();
	info.PhysicalDevice = device_.physical();
	info.Device = device_.handle();
	info.QueueFamily = device_.queueFamily();
	info.Queue = device_.queue();
	info.DescriptorPool = descriptors_;
	info.MinImageCount = info.ImageCount = static_cast<std::uint32_t>(kFramesInFlight);
	info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
	info.CheckVkResultFn = endOnFault;
	interface_started_ = true;
	return guarded(
	    [&]
	    {
		    beginInterface(info, render_pass_);
		    return uploadFonts(device_);
	    });
}

Result<bool> Screen::show(std::span<const Placement> pictures, ImDrawData& interface, VkExtent2D extent)
{
	if (!fits_ || extent.width != extent_.width || extent.height != extent_.height)
		if (Status made = makeTargets(extent); !made)
			return made.error();
	if (!fits_)
		return false;
	Frame& frame = frames_[frame_++ % kFramesInFlight];
	// Waits for the frame before the last one.
	Result<VkCommandBuffer> recording = frame.commands.begin();
	if (!recording)
		return recording.error();
	frame.holds.clear();
	const Result<std::optional<std::uint32_t>> index = acquire(frame);
	if (!index)
		return index.error();
	if (!*index)
		return false;
	const Target& target = targets_[**index];
	const auto recordAll = [&]() -> Status
	{
		record(*recording, target, pictures, interface);
		return Nothing{};
	};
	if (Status recorded = guarded(recordAll); !recorded)
		return recorded.error();
	for (const Placement& placed : pictures)
		frame.holds.push_back(placed.image);
	return finish(frame, **index);
}

Result<std::optional<std::uint32_t>> Screen::acquire(const Frame& frame)
{
	std::uint32_t index = 0;
	if (rows_)
		return std::optional(index);
	const VkResult acquired =
	    vkAcquireNextImageKHR(device_.handle(), swapchain_, kWaitsForImage, frame.acquired, VK_NULL_HANDLE, &index);
	if (acquired == VK_TIMEOUT)
		return std::optional<std::uint32_t>();
	if (acquired == VK_ERROR_OUT_OF_DATE_KHR)
	{
		fits_ = false;
		return std::optional<std::uint32_t>();
	}
	if (Status got = gpu::check(acquired, "vkAcquireNextImageKHR"); !got)
		return got.error();
	return std::optional(index);
}

Result<bool> Screen::finish(Frame& frame, std::uint32_t index)
{
	const Target& target = targets_[index];
	if (rows_)
	{
		if (Status drawn = frame.commands.submitAndWait(); !drawn)
			return drawn.error();
	}
	else if (auto submitted = frame.commands.submit({&frame.acquired, 1}, {&target.drawn, 1}); !submitted)
		return submitted.error();
	if (capture_)
		if (Status captured = finishCapture(target); !captured)
			return captured.error();
	if (!rows_)
		return present(index);
	own_pixels_.invalidate();
	const std::size_t bytes = std::size_t(4) * extent_.width * extent_.height;
	rows_->send({own_pixels_.mappedAs<std::byte>(), bytes}, extent_.width, extent_.height,
	            std::exchange(exposures_, window_.exposures()) != window_.exposures());
	return true;
}

std::optional<std::uint64_t> Screen::rowsSent() const
{
	return rows_ ? std::optional(rows_->rowsSent()) : std::nullopt;
}

void Screen::record(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures,
                    ImDrawData& interface)
{
	const VkImageAspectFlags color = VK_IMAGE_ASPECT_COLOR_BIT;
	gpu::imageBarrier(to, target.image, color, gpu::kDiscard, gpu::kCopyTo);
	recordPictures(to, target, pictures);
	gpu::imageBarrier(to, target.image, color, gpu::kCopyTo, gpu::kColorTarget);
	VkRenderPassBeginInfo begin{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
	begin.renderPass = render_pass_;
	begin.framebuffer = target.framebuffer;
	begin.renderArea.extent = extent_;
	vkCmdBeginRenderPass(to, &begin, VK_SUBPASS_CONTENTS_INLINE);
	ImGui_ImplVulkan_RenderDrawData(&interface, to);
	vkCmdEndRenderPass(to);
	gpu::imageBarrier(to, target.image, color, gpu::kColorTarget, finishedUse());
	if (rows_)
		recordPixels(to, target.image, finishedUse(), own_pixels_);
}

// Copies the pixels for the host, which waits for them.
void Screen::recordPixels(VkCommandBuffer to, VkImage from, const gpu::ImageUse& use, const gpu::Buffer& pixels) const
{
	gpu::imageBarrier(to, from, VK_IMAGE_ASPECT_COLOR_BIT, use, gpu::kCopyFrom);
	VkBufferImageCopy copy{};
	copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
	copy.imageExtent = {extent_.width, extent_.height, 1};
	vkCmdCopyImageToBuffer(to, from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels.handle(), 1, &copy);
	gpu::memoryBarrier(to, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_HOST_BIT,
	                   VK_ACCESS_2_HOST_READ_BIT);
	gpu::imageBarrier(to, from, VK_IMAGE_ASPECT_COLOR_BIT, gpu::kCopyFrom, use);
}

void Screen::recordPictures(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures) const
{
	// The image is cleared to the panels' color: a software device clears in no time, but takes a millisecond to draw
	// the background of a panel.
	const ImVec4& ground = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
	const VkClearColorValue color{{ground.x, ground.y, ground.z, 1.0f}};
	const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
	vkCmdClearColorImage(to, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1, &all);
	for (const Placement& placed : pictures)
	{
		const glm::ivec2 lo = glm::max(placed.lo, glm::ivec2(0));
		const glm::ivec2 hi = glm::min(placed.lo + placed.size, glm::ivec2(extent_.width, extent_.height));
		if (lo.x >= hi.x || lo.y >= hi.y || lo != placed.lo)
			continue;
		// If a picture reaches beyond the window, it is cropped, not squeezed.
		const VkExtent2D from = placed.image->extent();
		const glm::dvec2 part = glm::dvec2(hi - lo) / glm::dvec2(placed.size);
		const glm::ivec2 seen = glm::ivec2(part * glm::dvec2(from.width, from.height));
		gpu::imageBarrier(to, target.image, VK_IMAGE_ASPECT_COLOR_BIT, gpu::kCopyTo, gpu::kCopyTo);
		VkImageBlit blit{};
		blit.srcSubresource = blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		blit.srcOffsets[1] = corner(seen, 1);
		blit.dstOffsets[0] = corner(lo, 0);
		blit.dstOffsets[1] = corner(hi, 1);
		vkCmdBlitImage(to, placed.image->handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
		               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit,
		               seen == hi - lo ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
	}
}

// Waits for the frame, which is slow: only pictures of the window need this, not every frame.
Status Screen::finishCapture(const Target& target)
{
	const auto take = std::exchange(capture_, {});
	auto pixels = gpu::Buffer::create(device_, VkDeviceSize(4) * extent_.width * extent_.height,
	                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::readback, "captured frame");
	if (!pixels)
		return pixels.error();
	const Status copied = gpu::runOnce(
	    device_, "capture", [&](VkCommandBuffer to) { recordPixels(to, target.image, finishedUse(), *pixels); });
	if (!copied)
		return copied;
	pixels->invalidate();
	const auto* from = pixels->mappedAs<std::uint8_t>();
	render::Picture picture{
	    extent_.width, extent_.height, {from, from + std::size_t(4) * extent_.width * extent_.height}};
	for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
	{
		if (format_.format == VK_FORMAT_B8G8R8A8_UNORM)
			std::swap(picture.rgba[i], picture.rgba[i + 2]);
		picture.rgba[i + 3] = 255;
	}
	take(std::move(picture));
	return Nothing{};
}

Result<bool> Screen::present(std::uint32_t index)
{
	VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
	info.waitSemaphoreCount = 1;
	info.pWaitSemaphores = &targets_[index].drawn;
	info.swapchainCount = 1;
	info.pSwapchains = &swapchain_;
	info.pImageIndices = &index;
	const VkResult shown = device_.present(info);
	if (shown == VK_ERROR_OUT_OF_DATE_KHR || shown == VK_SUBOPTIMAL_KHR)
	{
		fits_ = false;
		return shown == VK_SUBOPTIMAL_KHR;
	}
	if (Status done = gpu::check(shown, "vkQueuePresentKHR"); !done)
		return done.error();
	return true;
}

} // namespace vp::app
