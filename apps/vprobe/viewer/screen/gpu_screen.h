#pragma once

#include "base/result.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "render/picture.h"
#include "viewer/screen/gpu_window.h"
#include "viewer/screen/row_sender.h"

#include <glm/vec2.hpp>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct ImDrawData;

namespace vp::app
{

// A picture (gpu::kCopyFrom) and the part of the window that it fills, in pixels from the top left.
struct Placement
{
	std::shared_ptr<const gpu::Image> image;
	glm::ivec2 lo{0};
	glm::ivec2 size{0};
};

// Shows pictures in a window, and the user interface over them: by the device, or row by row from the host
// (RowSender). Used by the window's thread only.
class Screen
{
public:
	// An ImGui context must exist. It and the window must outlive the screen.
	static Result<std::unique_ptr<Screen>> create(gpu::Device& device, const Window& window);
	~Screen();
	Screen(const Screen&) = delete;
	Screen& operator=(const Screen&) = delete;

	// Presents a frame. Returns false if nothing was shown: the window has another size now, which the next frame gets,
	// or the window system gave no image in time. pictures: they are held until the device is done with them.
	Result<bool> show(std::span<const Placement> pictures, ImDrawData& interface, VkExtent2D extent);
	// Passes the next frame to `take` as well.
	void capture(std::function<void(render::Picture)> take) { capture_ = std::move(take); }

	// Returns how many rows of pixels the host has sent to the window. Empty if the device presents.
	std::optional<std::uint64_t> rowsSent() const;

	// Takes ImGui's fonts as they are in its atlas now.
	Status takeFonts();

private:
	// There are two frames: the device draws one while the other is recorded. A third would only add lag.
	static constexpr std::size_t kFramesInFlight = 2;

	struct Frame
	{
		gpu::Commands commands;
		VkSemaphore acquired = VK_NULL_HANDLE;
		std::vector<std::shared_ptr<const gpu::Image>> holds;
	};
	struct Target // an image of the swapchain, or our own
	{
		VkImage image = VK_NULL_HANDLE;
		VkImageView view = VK_NULL_HANDLE;
		VkFramebuffer framebuffer = VK_NULL_HANDLE;
		VkSemaphore drawn = VK_NULL_HANDLE;
	};

	Screen(gpu::Device& device, const Window& window, VkSurfaceKHR surface)
	    : device_(device), window_(window), surface_(surface)
	{
	}
	Status chooseWay();
	Status chooseFormat();
	Status makeRenderPass();
	Status makeFrames();
	Status makeTargets(VkExtent2D extent);
	Status makeSwapchain(VkExtent2D extent);
	Status makeOwnTarget(VkExtent2D extent);
	Status addTarget(VkImage image);
	void dropTargets();
	// Returns the target's number. Empty if the window has another size now.
	Result<std::optional<std::uint32_t>> acquire(const Frame& frame);
	void record(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures, ImDrawData& interface);
	void recordPictures(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures) const;
	Status finishCapture(const Target& target);
	void recordPixels(VkCommandBuffer to, VkImage from, const gpu::ImageUse& use, const gpu::Buffer& pixels) const;
	Result<bool> finish(Frame& frame, std::uint32_t index);
	Result<bool> present(std::uint32_t index);
	const gpu::ImageUse& finishedUse() const { return rows_ ? gpu::kCopyFrom : gpu::kPresented; }

	gpu::Device& device_;
	const Window& window_;
	VkSurfaceKHR surface_;
	std::unique_ptr<RowSender> rows_; // null if the device presents
	gpu::Image own_;                  // target for the rows
	gpu::Buffer own_pixels_;
	std::uint64_t exposures_ = 0;
	VkSurfaceFormatKHR format_{};
	VkRenderPass render_pass_ = VK_NULL_HANDLE;
	VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
	VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
	VkExtent2D extent_{};
	bool fits_ = false; // the targets are as large as the window
	bool interface_started_ = false;
	std::vector<Target> targets_;
	std::array<Frame, kFramesInFlight> frames_;
	std::size_t frame_ = 0;
	std::function<void(render::Picture)> capture_;
};

} // namespace vp::app
