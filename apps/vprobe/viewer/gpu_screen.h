#pragma once

#include "base/result.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "render/picture.h"

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

// Shows pictures in a window, and the user interface over them. Used by the window's thread only.
class Screen
{
public:
	// Takes the surface. An ImGui context is there and lives longer.
	static Result<std::unique_ptr<Screen>> create(gpu::Device& device, VkSurfaceKHR surface, VkExtent2D extent);
	~Screen();
	Screen(const Screen&) = delete;
	Screen& operator=(const Screen&) = delete;

	// Presents a frame. False: the window has another size now, and nothing was shown; the next frame is made for it.
	// pictures: held until the device is done with them.
	Result<bool> show(std::span<const Placement> pictures, ImDrawData& interface, VkExtent2D extent);
	// The next frame is handed to `take` as well.
	void capture(std::function<void(render::Picture)> take) { capture_ = std::move(take); }

	// ImGui's fonts, as they are in its atlas now.
	Status takeFonts();

private:
	// Two frames: one that the device draws, one that is recorded. A third would only add lag to the hand's.
	static constexpr std::size_t kFramesInFlight = 2;

	struct Frame
	{
		gpu::Commands commands;
		VkSemaphore acquired = VK_NULL_HANDLE;
		std::vector<std::shared_ptr<const gpu::Image>> holds;
	};
	struct Target // an image of the swapchain
	{
		VkImage image = VK_NULL_HANDLE;
		VkImageView view = VK_NULL_HANDLE;
		VkFramebuffer framebuffer = VK_NULL_HANDLE;
		VkSemaphore drawn = VK_NULL_HANDLE;
	};

	Screen(gpu::Device& device, VkSurfaceKHR surface) : device_(device), surface_(surface) {}
	Status chooseFormat();
	Status makeRenderPass();
	Status makeFrames();
	Status makeSwapchain(VkExtent2D extent);
	Status addTarget(VkImage image);
	void dropTargets();
	void record(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures, ImDrawData& interface);
	void recordPictures(VkCommandBuffer to, const Target& target, std::span<const Placement> pictures) const;
	Status finishCapture(const Target& target);
	Result<bool> present(std::uint32_t index);

	gpu::Device& device_;
	VkSurfaceKHR surface_;
	VkSurfaceFormatKHR format_{};
	VkRenderPass render_pass_ = VK_NULL_HANDLE;
	VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
	VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
	VkExtent2D extent_{};
	bool fits_ = false; // the swapchain is as large as the window
	bool interface_started_ = false;
	std::vector<Target> targets_;
	std::array<Frame, kFramesInFlight> frames_;
	std::size_t frame_ = 0;
	std::function<void(render::Picture)> capture_;
};

} // namespace vp::app
