#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/scene.h"
#include "render/targets.h"

#include <map>
#include <vector>

namespace vp::render
{

// Draws each sheet's polygons into a layer of values of its own, with the hardware's rasterizer.
class LayerPass
{
public:
	static Result<LayerPass> create(gpu::Device& device);

	// Descriptors for the scene's records; before record(), while no submission draws.
	Status prepare(const Scene& scene);
	// Leaves the layers ready to be sampled.
	void record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter) const;

private:
	Status makeIndices(std::uint32_t records);
	// Made on first use, by their features: windows and mesh lines cost those who ask for them only.
	Result<const gpu::Pipeline*> pipelineFor(std::uint32_t features);

	gpu::Device* device_ = nullptr;
	std::map<std::uint32_t, gpu::Pipeline> pipelines_;
	std::vector<const gpu::Pipeline*> sheet_pipelines_; // of the scene prepared last
	gpu::DescriptorSets sets_;
	gpu::Buffer indices_;                    // of as many records as the largest page has
	std::vector<VkDescriptorSet> page_sets_; // in the order of sheets and their pages
};

} // namespace vp::render
