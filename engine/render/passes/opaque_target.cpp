#include "gpu/vulkan.h"

#include "render/passes/opaque_target.h"

#include "gpu/commands.h"
#include "render/passes/targets.h"

namespace vp::render
{

namespace
{

// Depths that are tested, and that shaders read.
constexpr gpu::ImageUse kReadDepth{OpaqueTarget::kDepthLayout, gpu::kDepthTarget.stages | gpu::kSampled.stages,
                                   VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | gpu::kSampled.access};

} // namespace

Status OpaqueTarget::prepare(gpu::Device& device, VkExtent2D extent, bool has_opaque)
{
	const auto make = [&](gpu::Image& image, VkExtent2D wanted, VkFormat format, VkImageUsageFlags usage,
	                      const char* name) -> Status
	{
		if (image && image.extent().width == wanted.width && image.extent().height == wanted.height)
			return Nothing{};
		image = {}; // before its successor, that both need not fit into memory
		gpu::ImageInfo info;
		info.extent = wanted;
		info.format = format;
		info.usage = usage | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
		auto made = gpu::Image::create(device, info, name);
		if (!made)
			return made.error();
		image = std::move(*made);
		return Nothing{};
	};
	has_opaque_ = has_opaque;
	if (Status made = make(nearest_, has_opaque ? extent : VkExtent2D{1, 1}, kFormat,
	                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT, "opaque surfaces");
	    !made)
		return made;
	return make(depth_, extent, kDepthFormat,
	            VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
	            "opaque surfaces' depth");
}

VkRenderingAttachmentInfo OpaqueTarget::testedDepth() const
{
	VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	depth.imageView = depth_.view();
	depth.imageLayout = kDepthLayout;
	depth.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
	depth.storeOp = VK_ATTACHMENT_STORE_OP_NONE;
	return depth;
}

void OpaqueTarget::recordBegin(VkCommandBuffer commands, const EdgeMask* edges) const
{
	nearest_.transition(commands, gpu::kDiscard, gpu::kColorTarget);
	depth_.transition(commands, gpu::kDiscard, edges ? gpu::kCopyTo : gpu::kDepthTarget);
	if (edges)
	{
		edges->recordCopy(commands, depth_);
		depth_.transition(commands, gpu::kCopyTo, gpu::kDepthTarget);
	}
	VkRenderingAttachmentInfo nearest{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	nearest.imageView = nearest_.view();
	nearest.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
	nearest.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
	nearest.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
	depth.imageView = depth_.view();
	depth.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
	depth.loadOp = edges ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
	depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
	VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
	rendering.renderArea.extent = depth_.extent();
	rendering.layerCount = 1;
	rendering.colorAttachmentCount = has_opaque_ ? 1 : 0;
	rendering.pColorAttachments = &nearest;
	rendering.pDepthAttachment = &depth;
	vkCmdBeginRendering(commands, &rendering);
	coverAll(commands, depth_.extent());
}

void OpaqueTarget::recordEnd(VkCommandBuffer commands) const
{
	vkCmdEndRendering(commands);
	nearest_.transition(commands, gpu::kColorTarget, gpu::kSampled);
	depth_.transition(commands, gpu::kDepthTarget, kReadDepth);
}

void OpaqueTarget::recordTaking(VkCommandBuffer commands, const gpu::Buffer& colors, const gpu::Buffer& depths) const
{
	const auto take = [&](const gpu::Image& image, const gpu::ImageUse& before, const gpu::Buffer& to)
	{
		VkBufferImageCopy copy{};
		copy.imageSubresource = {image.aspect(), 0, 0, 1};
		copy.imageExtent = {image.extent().width, image.extent().height, 1};
		image.transition(commands, before, gpu::kCopyFrom);
		vkCmdCopyImageToBuffer(commands, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.handle(), 1, &copy);
	};
	take(nearest_, gpu::kSampled, colors);
	take(depth_, kReadDepth, depths);
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

void OpaqueTarget::recordPutting(VkCommandBuffer commands, const gpu::Buffer& colors, const gpu::Buffer& depths) const
{
	const auto put = [&](const gpu::Image& image, const gpu::ImageUse& after, const gpu::Buffer& from)
	{
		VkBufferImageCopy copy{};
		copy.imageSubresource = {image.aspect(), 0, 0, 1};
		copy.imageExtent = {image.extent().width, image.extent().height, 1};
		image.transition(commands, gpu::kDiscard, gpu::kCopyTo);
		vkCmdCopyBufferToImage(commands, from.handle(), image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
		image.transition(commands, gpu::kCopyTo, after);
	};
	put(nearest_, gpu::kSampled, colors);
	put(depth_, kReadDepth, depths);
}

} // namespace vp::render
