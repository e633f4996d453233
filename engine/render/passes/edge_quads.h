#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/targets.h"

#include <cstdint>

namespace vp::render
{

// Where a picture without surfaces needs more samples than its first, which is in the picture: pixels whose color
// departs from the line between those on both sides, and those that the device colors together with one (EdgeMask says
// why). They are few, so each later sample takes them from a list (render_compose_quads.comp).
class EdgeQuads
{
public:
	static Result<EdgeQuads> create(gpu::Device& device);
	// Returns true if the device has room for the sums of a picture of this size.
	static bool fits(const gpu::Device& device, VkExtent2D extent);

	// Before recording, while no submission draws. reach: pixels around it that the color of a pixel depends on.
	Status prepare(const Targets& targets, std::uint32_t reach);
	// After the first sample is in the picture, a color target. Leaves it as storage.
	void record(VkCommandBuffer commands, const Targets& targets) const;
	// Between two samples, which add to the same sums.
	static void recordBarrier(VkCommandBuffer commands);

	// Gives back what prepare() has made for a picture.
	void release();

	const EdgeTiles& tiles() const { return tiles_; }
	// A shared::QuadList, and its quads.
	const gpu::Buffer& listed() const { return listed_; }
	const gpu::Buffer& sums() const { return sums_; }

private:
	gpu::Device* device_ = nullptr;
	gpu::Pipeline find_;
	gpu::DescriptorSets sets_;
	gpu::Sampler sampler_;
	EdgeTiles tiles_;
	gpu::Buffer listed_;
	gpu::Buffer sums_;
	VkExtent2D extent_{};
	VkDescriptorSet set_ = VK_NULL_HANDLE;
};

} // namespace vp::render
