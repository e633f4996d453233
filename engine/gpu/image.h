#pragma once

#include "gpu/device.h"
#include "gpu/memory.h"

#include <cstddef>
#include <span>
#include <utility>

namespace vp::gpu
{

// The use of an image before or after a barrier.
struct ImageUse
{
	VkImageLayout layout;
	VkPipelineStageFlags2 stages;
	VkAccessFlags2 access;
};

constexpr ImageUse kDiscard{VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                            VK_ACCESS_2_NONE}; // content is dropped
constexpr ImageUse kColorTarget{VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT};
constexpr ImageUse kDepthTarget{
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
constexpr ImageUse kSampled{VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                            VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                            VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
constexpr ImageUse kStorage{VK_IMAGE_LAYOUT_GENERAL,
                            VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                            VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
constexpr ImageUse kCopyFrom{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                             VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr ImageUse kCopyTo{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                           VK_ACCESS_2_TRANSFER_WRITE_BIT};
constexpr ImageUse kPresented{VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE};

struct ImageInfo
{
	VkExtent2D extent{};
	VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
	VkImageUsageFlags usage = 0;
	std::uint32_t layers = 1; // more than one: the view is an array
	VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

// A 2-D image in device-local memory with a view of the whole of it. Move-only, as Buffer.
class Image
{
public:
	Image() = default;
	static Result<Image> create(Device& device, const ImageInfo& info, std::string_view name);
	~Image();
	Image(Image&& other) noexcept { swap(other); }
	Image& operator=(Image&& other) noexcept
	{
		Image taken(std::move(other));
		swap(taken);
		return *this;
	}

	explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
	VkImage handle() const { return handle_; }
	VkImageView view() const { return view_; }
	VkExtent2D extent() const { return info_.extent; }
	VkFormat format() const { return info_.format; }
	std::uint32_t layers() const { return info_.layers; }
	VkImageAspectFlags aspect() const;

	// The barrier between two uses, layout included.
	void transition(VkCommandBuffer commands, const ImageUse& before, const ImageUse& after) const;

private:
	void swap(Image& other) noexcept;

	Device* device_ = nullptr;
	VkImage handle_ = VK_NULL_HANDLE;
	Arena::Piece piece_;
	VkImageView view_ = VK_NULL_HANDLE;
	ImageInfo info_;
};

// For images that are not ours (a swapchain's).
void imageBarrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& before,
                  const ImageUse& after);

// Puts tightly packed pixels into an image (COPY_TO usage) and leaves it ready for `after`; done on return.
Status uploadImage(Device& device, const Image& image, std::span<const std::byte> pixels, const ImageUse& after);

class Sampler
{
public:
	Sampler() = default;
	// Clamped to the edge.
	static Result<Sampler> create(Device& device, VkFilter filter, std::string_view name);
	~Sampler();
	Sampler(Sampler&& other) noexcept { swap(other); }
	Sampler& operator=(Sampler&& other) noexcept
	{
		Sampler taken(std::move(other));
		swap(taken);
		return *this;
	}
	VkSampler handle() const { return handle_; }

private:
	void swap(Sampler& other) noexcept
	{
		std::swap(device_, other.device_);
		std::swap(handle_, other.handle_);
	}

	Device* device_ = nullptr;
	VkSampler handle_ = VK_NULL_HANDLE;
};

} // namespace vp::gpu
