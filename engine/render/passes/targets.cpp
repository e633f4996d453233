#include "gpu/vulkan.h"

#include "render/passes/targets.h"

#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/vk_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::render
{

namespace
{

Result<VkImageView> makeView(gpu::Device& device, const gpu::Image& image, VkImageViewType type, std::uint32_t first,
                             std::uint32_t count)
{
	VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
	info.image = image.handle();
	info.viewType = type;
	info.format = image.format();
	info.subresourceRange = {image.aspect(), 0, 1, first, count};
	VkImageView view = VK_NULL_HANDLE;
	if (Status made = gpu::check(vkCreateImageView(device.handle(), &info, nullptr, &view), "vkCreateImageView"); !made)
		return made.error();
	device.setName(VK_OBJECT_TYPE_IMAGE_VIEW, view, fmt::format("value layers {}", first));
	return view;
}

} // namespace

VkFormat sumFormat(gpu::Device& device)
{
	VkFormatProperties properties{};
	vkGetPhysicalDeviceFormatProperties(device.physical(), VK_FORMAT_R32G32B32A32_SFLOAT, &properties);
	constexpr VkFormatFeatureFlags needed =
	    VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
	return (properties.optimalTilingFeatures & needed) == needed ? VK_FORMAT_R32G32B32A32_SFLOAT
	                                                             : VK_FORMAT_R16G16B16A16_SFLOAT;
}

Result<Targets> Targets::create(gpu::Device& device, const PicturePart& first, std::uint32_t layers, bool mesh,
                                bool sum)
{
	const VkExtent2D extent = first.picture;
	if (std::max(extent.width, extent.height) > device.limits().maxImageDimension2D)
		return Error{ErrorKind::usage, fmt::format("`size`: {}x{} is more than this device draws; take up to {} a side",
		                                           extent.width, extent.height, device.limits().maxImageDimension2D)};
	Targets targets;
	targets.device_ = &device;
	targets.part_ = first;
	const auto make = [&](gpu::Image& image, VkFormat format, VkImageUsageFlags usage, std::uint32_t count,
	                      const char* name) -> Status
	{
		gpu::ImageInfo info;
		info.extent = format == kPictureFormat ? extent : first.extent;
		info.format = format;
		info.usage = usage;
		info.layers = count;
		auto made = gpu::Image::create(device, info, name);
		if (!made)
			return made.error();
		image = std::move(*made);
		return Nothing{};
	};
	// Mesh lines are drawn by the hardware's rasterizer alone.
	const VkImageUsageFlags computed = mesh ? 0 : VkImageUsageFlags(VK_IMAGE_USAGE_STORAGE_BIT);
	if (Status made = make(targets.values, layerFormat(mesh),
	                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
	                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | computed,
	                       layers, "value layers");
	    !made)
		return made.error();
	if (Status made =
	        make(targets.lines, kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
	             1, "outline's depth");
	    !made)
		return made.error();
	if (sum)
		if (Status made = make(targets.sum, sumFormat(device),
		                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT, 1, "sum of samples");
		    !made)
			return made.error();
	if (Status made = make(targets.picture, kPictureFormat,
	                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
	                           VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
	                       1, "picture");
	    !made)
		return made.error();
	auto pixels = gpu::Buffer::create(device, VkDeviceSize(4) * extent.width * extent.height,
	                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::Memory::readback, "picture's pixels");
	if (!pixels)
		return pixels.error();
	targets.pixels = std::move(*pixels);

	for (std::uint32_t i = 0; i < layers; ++i)
	{
		auto view = makeView(device, targets.values, VK_IMAGE_VIEW_TYPE_2D, i, 1);
		if (!view)
			return view.error();
		targets.layer_views_.push_back(*view);
	}
	auto all = makeView(device, targets.values, VK_IMAGE_VIEW_TYPE_2D_ARRAY, 0, layers);
	if (!all)
		return all.error();
	targets.layers_view_ = *all;
	return targets;
}

Targets::~Targets()
{
	if (!device_)
		return;
	device_->retire(
	    [views = std::move(layer_views_), all = layers_view_](VkDevice device)
	    {
		    for (const VkImageView view : views)
			    vkDestroyImageView(device, view, nullptr);
		    vkDestroyImageView(device, all, nullptr);
	    });
}

bool Targets::holds(const PicturePart& part, std::uint32_t layers, bool mesh, bool sum) const
{
	const auto same = [](VkExtent2D a, VkExtent2D b) { return a.width == b.width && a.height == b.height; };
	return values && same(part_.picture, part.picture) && same(part_.extent, part.extent) &&
	       layers <= values.layers() && values.format() == layerFormat(mesh) && (!sum || this->sum);
}

void Targets::swap(Targets& other) noexcept
{
	std::swap(values, other.values);
	std::swap(lines, other.lines);
	std::swap(sum, other.sum);
	std::swap(picture, other.picture);
	std::swap(pixels, other.pixels);
	std::swap(device_, other.device_);
	std::swap(part_, other.part_);
	std::swap(layer_views_, other.layer_views_);
	std::swap(layers_view_, other.layers_view_);
}

void Targets::recordCopy(VkCommandBuffer commands, const gpu::Image* into) const
{
	const VkExtent3D extent{part_.picture.width, part_.picture.height, 1};
	constexpr VkImageSubresourceLayers color{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
	if (into)
	{
		VkImageCopy copy{};
		copy.srcSubresource = copy.dstSubresource = color;
		copy.extent = extent;
		into->transition(commands, gpu::kDiscard, gpu::kCopyTo);
		vkCmdCopyImage(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, into->handle(),
		               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
		return into->transition(commands, gpu::kCopyTo, gpu::kCopyFrom);
	}
	VkBufferImageCopy copy{};
	copy.imageSubresource = color;
	copy.imageExtent = extent;
	vkCmdCopyImageToBuffer(commands, picture.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels.handle(), 1, &copy);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

std::vector<std::uint8_t> Targets::readPixels(bool is_opaque) const
{
	pixels.invalidate();
	const auto* from = pixels.mappedAs<std::uint8_t>();
	std::vector<std::uint8_t> rgba(from, from + std::size_t(4) * part_.picture.width * part_.picture.height);
	if (is_opaque)
		return rgba;
	for (std::size_t i = 0; i < rgba.size(); i += 4)
	{
		const int alpha = rgba[i + 3];
		if (alpha == 0 || alpha == 255)
			continue;
		for (int c = 0; c < 3; ++c)
			rgba[i + c] = static_cast<std::uint8_t>(std::min(255, (rgba[i + c] * 255 + alpha / 2) / alpha));
	}
	return rgba;
}

void coverAll(VkCommandBuffer commands, VkExtent2D extent)
{
	coverPart(commands, extent, {{0, 0}, extent});
}

void coverPart(VkCommandBuffer commands, VkExtent2D extent, const VkRect2D& part)
{
	const VkViewport viewport{0.0f, 0.0f, static_cast<float>(extent.width), static_cast<float>(extent.height),
	                          0.0f, 1.0f};
	vkCmdSetViewport(commands, 0, 1, &viewport);
	vkCmdSetScissor(commands, 0, 1, &part);
}

} // namespace vp::render
