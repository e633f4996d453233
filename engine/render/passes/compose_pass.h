#pragma once

#include "gpu/shader.h"
#include "render/passes/buffers.h"
#include "render/passes/edge_mask.h"
#include "render/passes/edge_quads.h"
#include "render/passes/fragment_lists.h"
#include "render/passes/opaque_target.h"
#include "render/passes/targets.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <array>
#include <map>
#include <optional>
#include <tuple>

namespace vp::render
{

// Returns true if the first sample goes straight into the picture, and others are added at edges only. The picture must
// be drawn in one part, without lists that may overflow.
bool composesWhole(const gpu::Device& device, const Scene& scene, const PicturePart& part);

// Orders the layers at each pixel, and the surfaces' fragments where there are surfaces, colors and blends them
// (render_compose.glsl). If not composesWhole(), samples are summed up, and at last their mean comes over the
// background (render_resolve.frag).
class ComposePass
{
public:
	static Result<ComposePass> create(gpu::Device& device);

	// Where the scene's surfaces are drawn into.
	struct SurfaceTargets
	{
		const FragmentLists& lists;
		const OpaqueTarget& opaque;
		bool has_opaque;
	};
	// Where later samples are drawn: one of both, or none for a picture of one sample.
	struct Edges
	{
		const EdgeMask* mask = nullptr;
		const EdgeQuads* quads = nullptr; // if composesWhole()
	};
	// surfaces: prepared for the scene's surfaces; null where it has none.
	Status prepare(const Scene& scene, const Targets& targets, const SurfaceTargets* surfaces, const Edges& edges);
	// A part of the picture, all of it or a strip. edges: null for the first sample, which begins anew with its first
	// part; the others are drawn at edges only.
	void record(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter, const VkRect2D& part,
	            const EdgeMask* edges, bool first_part) const;
	// If composesWhole(): the first sample into the picture, which is a color target.
	void recordWhole(VkCommandBuffer commands, const Targets& targets, const glm::dvec2& jitter) const;
	// And the others at edges; the last one puts them into the picture, which is storage.
	void recordQuads(VkCommandBuffer commands, const EdgeQuads& quads, const glm::dvec2& jitter, std::size_t sample,
	                 std::size_t samples) const;
	// Within a rendering into the picture, after the last sample of a part: these rows of the picture.
	void recordResolve(VkCommandBuffer commands, const Targets& targets, const VkRect2D& rows) const;

private:
	gpu::Device* device_ = nullptr;
	// The shader holds a pixel's layers in registers and sorts them all: as few of them as do (software takes 12 ns
	// more a pixel for four than for one).
	static constexpr std::array<std::uint32_t, 6> kSlots{1, 2, 3, 4, 8, shared::kMaxLayers};

	// Draws everywhere, or at edges only.
	struct Pipelines
	{
		gpu::Pipeline everywhere;
		gpu::Pipeline at_edges;       // if there is a mask
		gpu::Pipeline quads;          // or quads
		std::uint64_t last_scene = 0; // for which they were used
		bool lends_layout = false;    // to descriptor sets
	};
	// Made on first use; the pointer stays valid while the scene is the last one.
	Result<Pipelines*> pipelinesFor(std::size_t layers, std::uint32_t features, bool surfaces, const Edges& edges);
	Result<gpu::Pipeline> makePipeline(std::uint32_t slots, std::uint32_t features, bool surfaces, bool at_edges) const;
	Result<gpu::Pipeline> makeQuadsPipeline(std::uint32_t slots, std::uint32_t features) const;
	void forgetOldPipelines();
	Status prepareRegions(const Scene& scene, const Targets& targets, std::uint32_t features, const Edges& edges);
	Status writeQuadsSet(const Targets& targets, const EdgeQuads& quads);
	Status writeResolveSet(const Targets& targets, const EdgeMask* mask);
	void recordInto(VkCommandBuffer commands, const Targets& targets, VkImageView view, const glm::dvec2& jitter,
	                const VkRect2D& part, VkAttachmentLoadOp load, const EdgeMask* edges) const;
	Result<VkDescriptorSet> compositionSet(const Targets& targets, const SurfaceTargets* surfaces);

	std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, Pipelines> pipelines_; // by slots, features, surfaces
	std::uint64_t scenes_ = 0;                                                      // prepared so far
	// The scene prepared last: the pipelines that draw all its sheets, and its regions.
	struct Region
	{
		VkRect2D pixels;
		const Pipelines* pipelines;
		shared::ComposePush push;
	};
	Pipelines* pipelines_in_use_ = nullptr;
	shared::ComposePush all_sheets_{};
	std::vector<Region> regions_;
	gpu::Pipeline resolve_;
	gpu::DescriptorSets sets_;
	std::optional<gpu::DescriptorSets> surface_sets_; // made on first use
	std::optional<gpu::DescriptorSets> quads_sets_;   // made on first use
	gpu::DescriptorSets resolve_sets_;
	gpu::Sampler sampler_;
	gpu::Buffer params_;
	HostTexels tables_;
	HostTexels colors_; // colors of the layers
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	VkDescriptorSet quads_set_ = VK_NULL_HANDLE;
	VkDescriptorSet resolve_set_ = VK_NULL_HANDLE;
};

} // namespace vp::render
