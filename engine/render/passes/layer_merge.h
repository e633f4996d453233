#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/passes/targets.h"
#include "render/scene/layer_values.h"

namespace vp::render
{

// Brings the layers of values to the host and back, so that others can take part in them.
class LayerMerge
{
public:
	// The layers have been recorded. Submits that, and gives them and the surfaces (or null) to `merge`. Returns the
	// commands to go on with, or null if another process goes on.
	Result<VkCommandBuffer> run(gpu::Device& device, gpu::Commands& commands, const Targets& targets,
	                            std::uint32_t layers, SurfaceFragments* surfaces, const MergeLayers& merge);

private:
	Status take(gpu::Device& device, gpu::Commands& commands, const Targets& targets, LayerValues& all);

	gpu::Buffer values_;
};

} // namespace vp::render
