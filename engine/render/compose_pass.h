#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/scene.h"
#include "render/targets.h"
#include "shared/render_types.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace vp::render
{

// Orders the layers at each pixel, colours and blends them, and sums up the samples (render_compose.frag); at last puts
// their mean over the background (render_resolve.frag).
class ComposePass
{
public:
	static Result<ComposePass> create(gpu::Device& device);

	Status prepare(const Scene& scene, const Targets& targets);
	void record(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter, bool first) const;
	// Within a rendering into the picture, after the last sample.
	void recordResolve(VkCommandBuffer commands, const Targets& targets) const;

private:
	gpu::Device* device_ = nullptr;
	// The shader holds a pixel's layers in registers and sorts them all: as few of them as do (software takes 12 ns
	// more a pixel for four than for one).
	static constexpr std::array<std::uint32_t, 6> kSlots{1, 2, 3, 4, 8, shared::kMaxLayers};

	// Made on first use; the pointer stays valid.
	Result<const gpu::Pipeline*> pipelineFor(std::size_t layers, std::uint32_t features);
	Status putTables(const std::vector<std::uint32_t>& tables);

	std::map<std::pair<std::uint32_t, std::uint32_t>, gpu::Pipeline> pipelines_; // by slots and features
	const gpu::Pipeline* pipeline_ = nullptr;                                    // of the scene prepared last
	gpu::Pipeline resolve_;
	gpu::DescriptorSets sets_;
	gpu::DescriptorSets resolve_sets_;
	gpu::Sampler sampler_;
	gpu::Buffer params_;
	gpu::Buffer tables_;
	gpu::TexelView table_texels_;
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	VkDescriptorSet resolve_set_ = VK_NULL_HANDLE;
};

} // namespace vp::render
