#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/shader.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/targets.h"

#include <cstdint>

namespace vp::render
{

// Where a picture needs more samples than its first: at pixels whose color departs from the line between those on both
// sides (render_edges.frag). Elsewhere the first sample stands for all of them. Its place is near the pixel's middle,
// so along a slope it has their mean.
class EdgeMask
{
public:
	static Result<EdgeMask> create(gpu::Device& device);

	// Before recording, while no submission draws. reach: pixels around it that the color of a pixel depends on. The
	// targets have at most maxTexelBufferElements squares.
	Status prepare(const Targets& targets, std::uint32_t reach);
	// After the first sample is in the sum, which stays a color target.
	void record(VkCommandBuffer commands, const Targets& targets) const;

	// As the depth of a rendering it lets nothing pass but what is drawn at an edge: 0 there, 1 elsewhere. Depths are
	// compared by GREATER_OR_EQUAL.
	VkRenderingAttachmentInfo asDepth() const;
	const gpu::Image& image() const { return image_; }
	static constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL; // after record()
	void recordCopy(VkCommandBuffer commands, const gpu::Image& to) const;            // `to` is in gpu::kCopyTo

	const EdgeTiles& tiles() const { return tiles_; }

private:
	gpu::Device* device_ = nullptr;
	gpu::Pipeline find_;
	gpu::Pipeline list_;
	gpu::DescriptorSets find_sets_;
	gpu::DescriptorSets list_sets_;
	gpu::Sampler sampler_;
	gpu::Image image_;
	EdgeTiles tiles_;
	VkDescriptorSet find_set_ = VK_NULL_HANDLE;
	VkDescriptorSet list_set_ = VK_NULL_HANDLE;
};

} // namespace vp::render
