#pragma once

#include "gpu/buffer.h"
#include "gpu/vulkan.h"
#include "render/passes/fragment_lists.h"
#include "render/passes/surface_pass.h"
#include "render/scene/layer_values.h"

namespace vp::render
{

// Brings what surfaces show to the host and back, so that others can take part in it.
class SurfaceMerge
{
public:
	// Behind the surfaces of a sample, which were drawn in one strip.
	Status recordTaking(gpu::Device& device, VkCommandBuffer commands, const FragmentLists& lists,
	                    const SurfacePass& surfaces);
	// Once that is done: what was drawn.
	SurfaceFragments taken(const SurfacePass& surfaces) const;
	// In place of drawing. The lists have room for all fragments.
	Status recordPutting(gpu::Device& device, VkCommandBuffer commands, const SurfaceFragments& fragments,
	                     const FragmentLists& lists, const SurfacePass& surfaces);

private:
	Status makeBuffers(gpu::Device& device, const FragmentLists& lists);
	std::size_t pixels() const { return std::size_t(extent_.width) * extent_.height; }

	VkExtent2D extent_{};
	gpu::Buffer heads_;
	gpu::Buffer fragments_;
	gpu::Buffer colors_;
	gpu::Buffer depths_;
};

} // namespace vp::render
