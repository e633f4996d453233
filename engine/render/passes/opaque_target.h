#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "render/passes/edge_mask.h"

namespace vp::render
{

// The nearest fragment of the opaque surfaces at each pixel, and its depth. It ends the pixel's list of fragments: the
// composing pass sees nothing behind it. Depths are there without opaque surfaces too: later samples are drawn at edges
// only, and nothing passes the depths elsewhere.
class OpaqueTarget
{
public:
	static constexpr VkFormat kFormat = VK_FORMAT_R32G32_UINT; // color, and the surface's number

	// Before recording, while no submission draws. Without opaque surfaces colors are one pixel, which is not read.
	Status prepare(gpu::Device& device, VkExtent2D extent, bool has_opaque);

	// Between these, opaque surfaces are drawn. Then shaders may read both images, and depths may be tested. edges:
	// null for a picture's first sample.
	void recordBegin(VkCommandBuffer commands, const EdgeMask* edges) const;
	void recordEnd(VkCommandBuffer commands) const;
	VkRenderingAttachmentInfo testedDepth() const;
	// After recordEnd(): copies both to a host's buffers, and, in place of drawing, from there.
	void recordTaking(VkCommandBuffer commands, const gpu::Buffer& colors, const gpu::Buffer& depths) const;
	void recordPutting(VkCommandBuffer commands, const gpu::Buffer& colors, const gpu::Buffer& depths) const;
	static constexpr VkImageLayout kDepthLayout = VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL; // after recordEnd()

	const gpu::Image& nearest() const { return nearest_; }
	const gpu::Image& depth() const { return depth_; }

private:
	bool has_opaque_ = false;
	gpu::Image nearest_;
	gpu::Image depth_; // near / w; 0: nothing
};

} // namespace vp::render
