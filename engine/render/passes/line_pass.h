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
	// Does not draw lines again that would come out the same. edges: the edges of the picture's first sample; then only
	// pixels near them are sure to be right. Null: all pixels are.
	void record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter,
	            const EdgeTiles* edges = nullptr);
	// Call it if the recorded commands did not run, or if the depths are new.
	void forget() { drawn_.reset(); }

private:
	// The sources that the depths were drawn from, beside the segments.
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
	gpu::Pipeline clear_; // clears the surroundings of edges; made on first use
	gpu::DescriptorSets clear_sets_;
	gpu::Buffer segments_;
	VkDescriptorSet set_ = VK_NULL_HANDLE;
	VkDescriptorSet clear_set_ = VK_NULL_HANDLE;
	Vec3 center_{0.0}; // origin of the segments
	std::uint32_t count_ = 0;
	std::vector<shared::LineSegment> kept_; // those on the device
	std::optional<Drawn> drawn_;
};

} // namespace vp::render
