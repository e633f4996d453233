#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/targets.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace vp::render
{

// Draws the outline and the windows' rims into a depth image: near / w of the nearest line at each pixel, 0 where there
// is none.
class LinePass
{
public:
	static Result<LinePass> create(gpu::Device& device);

	// edges: null where all samples are drawn everywhere.
	Status prepare(const Scene& scene, const EdgeTiles* edges);
	// Lines that would come out as they are already are left as they are. edges: of the picture's first sample; then
	// what is not near them is not sure to be right. Null: all is.
	void record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter,
	            const EdgeTiles* edges = nullptr);
	// What was recorded did not run, or the depths are others.
	void forget() { drawn_.reset(); }

private:
	// What the depths were drawn from, beside the segments.
	struct Drawn
	{
		std::uint32_t count;
		shared::LinePush push;
		bool only_edges;
	};
	Status prepareClearing(const EdgeTiles& edges);
	void recordClearTiles(VkCommandBuffer commands, const Targets& targets, const EdgeTiles& edges) const;

	shared::LinePush linePush(const Scene& scene, const PicturePart& part, const glm::dvec2& jitter) const;

	gpu::Device* device_ = nullptr;
	gpu::Pipeline pipeline_;
	gpu::DescriptorSets sets_;
	gpu::Pipeline clear_; // of the surroundings of edges; made on first use
	gpu::DescriptorSets clear_sets_;
	gpu::Buffer segments_;
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	VkDescriptorSet clear_set_ = VK_NULL_HANDLE;
	Vec3 center_{0.0}; // that the segments are relative to
	std::uint32_t count_ = 0;
	std::vector<shared::LineSegment> kept_; // those on the device
	std::optional<Drawn> drawn_;
};

} // namespace vp::render
