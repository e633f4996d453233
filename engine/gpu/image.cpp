#include "gpu/image.h"

#include "gpu/commands.h"
#include "gpu/upload.h"
#include "gpu/vk_check.h"

namespace vp::gpu
{

namespace
{
VkImageAspectFlags aspectOf(VkFormat format)
{
	switch (format)
	{
	case VK_FORMAT_D16_UNORM:
	case VK_FORMAT_D32_SFLOAT:
	case VK_FORMAT_X8_D24_UNORM_PACK32:
		return VK_IMAGE_ASPECT_DEPTH_BIT;
	case VK_FORMAT_D24_UNORM_S8_UINT:
	case VK_FORMAT_D32_SFLOAT_S8_UINT:
		return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
	default:
		return VK_IMAGE_ASPECT_COLOR_BIT;
	}
}
} // namespace

Result<Image> Image::create(Device& device, const ImageInfo& info, std::string_view name)
{
	VkImageCreateInfo create{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
	create.imageType = VK_IMAGE_TYPE_2D;
	create.format = info.format;
	create.extent = {info.extent.width, info.extent.height, 1};
	create.mipLevels = 1;
	create.arrayLayers = info.layers;
	create.samples = info.samples;
	create.usage = info.usage;
	Image image;
	if (Status made = check(vkCreateImage(device.handle(), &create, nullptr, &image.handle_), "vkCreateImage"); !made)
		return made.error();
	image.device_ = &device;
	image.info_ = info;
	device.setName(VK_OBJECT_TYPE_IMAGE, image.handle_, name);

	VkMemoryRequirements requirements;
	vkGetImageMemoryRequirements(device.handle(), image.handle_, &requirements);
	Result<Arena::Piece> piece = device.arena().take(requirements, Memory::device);
	if (!piece)
		return piece.error();
	image.piece_ = *piece;
	if (Status bound =
	        check(vkBindImageMemory(device.handle(), image.handle_, piece->memory, piece->offset), "vkBindImageMemory");
	    !bound)
		return bound.error();

	VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
	view.image = image.handle_;
	view.viewType = info.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
	view.format = info.format;
	view.subresourceRange = {image.aspect(), 0, 1, 0, info.layers};
	// A transfer-only image has no view.
	constexpr VkImageUsageFlags kTransfers = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
	if (info.usage & ~kTransfers)
	{
		if (Status made = check(vkCreateImageView(device.handle(), &view, nullptr, &image.view_), "vkCreateImageView");
		    !made)
			return made.error();
		device.setName(VK_OBJECT_TYPE_IMAGE_VIEW, image.view_, name);
	}
	return image;
}

Image::~Image()
{
	if (handle_)
		device_->retire(
		    [handle = handle_, piece = piece_, view = view_, &arena = device_->arena()](VkDevice device)
		    {
			    vkDestroyImageView(device, view, nullptr);
			    vkDestroyImage(device, handle, nullptr);
			    if (piece.page)
				    arena.give(piece);
		    });
}

VkImageAspectFlags Image::aspect() const
{
	return aspectOf(info_.format);
}

void Image::transition(VkCommandBuffer commands, const ImageUse& before, const ImageUse& after) const
{
	imageBarrier(commands, handle_, aspect(), before, after);
}

void Image::swap(Image& other) noexcept
{
	std::swap(device_, other.device_);
	std::swap(handle_, other.handle_);
	std::swap(piece_, other.piece_);
	std::swap(view_, other.view_);
	std::swap(info_, other.info_);
}

void imageBarrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& before,
                  const ImageUse& after)
{
	VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
	barrier.srcStageMask = before.stages;
	barrier.srcAccessMask = before.access;
	barrier.dstStageMask = after.stages;
	barrier.dstAccessMask = after.access;
	barrier.oldLayout = before.layout;
	barrier.newLayout = after.layout;
	barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
	barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
	barrier.image = image;
	barrier.subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
	VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
	dependency.imageMemoryBarrierCount = 1;
	dependency.pImageMemoryBarriers = &barrier;
	vkCmdPipelineBarrier2(commands, &dependency);
}

Status uploadImage(Device& device, const Image& image, std::span<const std::byte> pixels, const ImageUse& after)
{
	Result<Buffer> staging =
	    Buffer::create(device, pixels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, Memory::upload, "image staging");
	if (!staging)
		return staging.error();
	if (Status filled = upload(*staging, pixels); !filled)
		return filled.error();
	return runOnce(device, "upload image",
	               [&](VkCommandBuffer commands)
	               {
		               image.transition(commands, kDiscard, kCopyTo);
		               VkBufferImageCopy region{};
		               region.imageSubresource = {image.aspect(), 0, 0, image.layers()};
		               region.imageExtent = {image.extent().width, image.extent().height, 1};
		               vkCmdCopyBufferToImage(commands, staging->handle(), image.handle(),
		                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
		               image.transition(commands, kCopyTo, after);
	               });
}

Result<Sampler> Sampler::create(Device& device, VkFilter filter, std::string_view name)
{
	VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
	info.magFilter = filter;
	info.minFilter = filter;
	info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
	info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
	info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
	info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
	info.maxLod = VK_LOD_CLAMP_NONE;
	Sampler sampler;
	if (Status made = check(vkCreateSampler(device.handle(), &info, nullptr, &sampler.handle_), "vkCreateSampler");
	    !made)
		return made.error();
	sampler.device_ = &device;
	device.setName(VK_OBJECT_TYPE_SAMPLER, sampler.handle_, name);
	return sampler;
}

Sampler::~Sampler()
{
	if (handle_)
		device_->retire([handle = handle_](VkDevice device) { vkDestroySampler(device, handle, nullptr); });
}

} // namespace vp::gpu
