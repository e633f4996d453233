#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/raster_pass.h"
#include "render/passes/targets.h"
#include "render/scene/scene.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace vp::render
{

// Draws each sheet's polygons into a layer of values of its own, with a compute shader where that can be, else with the
// hardware's rasterizer. A layer that would come out as it is already is left as it is.
class LayerPass
{
public:
	// raster_side: RasterPass::record(); 0: all goes the hardware's way.
	static Result<LayerPass> create(gpu::Device& device, std::uint32_t raster_side);

	// Descriptors for the scene's records; before record(), while no submission draws. edges: null for a picture of one
	// sample.
	Status prepare(const Scene& scene, const Targets& targets, const EdgeTiles* edges = nullptr);
	// Leaves the layers ready to be sampled. Returns how many were drawn. edges: the edges of the picture's first
	// sample; then only pixels near them are sure to be drawn. Null: all pixels are.
	std::size_t record(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter,
	                   const EdgeTiles* edges = nullptr);
	// Call it if the recorded commands did not run, or if the layers are new.
	void forget() { drawn_.clear(); }

private:
	// The sources that a layer was drawn from.
	struct Drawn
	{
		std::weak_ptr<const classify::SheetRecords> records; // weak: their pages go back to be filled anew
		std::size_t record_count = 0;                        // 0: an empty layer
		std::uint32_t features = 0;
		bool only_edges = false; // elsewhere it holds what an earlier sample has left
		shared::LayerPush push{};

		bool operator==(const Drawn& other) const;
	};
	bool isComputed(std::size_t layer) const { return layer < computed_.size() && computed_[layer]; }
	bool computes(const Scene& scene, const SheetDrawing& sheet) const;
	Status makeIndices(std::uint32_t records);
	// Made on first use, by their features: windows and mesh lines cost those who ask for them only.
	Result<const gpu::Pipeline*> pipelineFor(std::uint32_t features);
	std::vector<Drawn> wanted(const Scene& scene, const PicturePart& part, const glm::dvec2& jitter,
	                          bool only_edges) const;
	void recordComputed(VkCommandBuffer commands, const Scene& scene, const Targets& targets, const glm::dvec2& jitter,
	                    const EdgeTiles* edges, const gpu::ImageUse& before, std::span<const std::size_t> layers);
	Status makeClearSets(std::size_t layers, const Targets& targets, const EdgeTiles& edges);
	void recordClearAll(VkCommandBuffer commands, const Targets& targets, std::span<const std::size_t> layers) const;
	void recordClearTiles(VkCommandBuffer commands, const EdgeTiles& edges, std::span<const std::size_t> layers) const;
	void drawPages(VkCommandBuffer commands, const classify::SheetRecords& records, std::size_t i,
	               const shared::LayerPush& push) const;
	void recordLayer(VkCommandBuffer commands, const Scene& scene, const Targets& targets, std::size_t i,
	                 const shared::LayerPush& push) const;

	gpu::Device* device_ = nullptr;
	RasterPass raster_;
	std::uint32_t raster_side_ = 0;
	std::map<std::uint32_t, gpu::Pipeline> pipelines_;
	gpu::DescriptorSets sets_;
	gpu::Pipeline clear_; // clears the surroundings of edges; made on first use
	gpu::DescriptorSets clear_sets_;
	gpu::Buffer indices_; // indices of as many records as the largest page has
	// The scene prepared last, per sheet.
	std::vector<const gpu::Pipeline*> sheet_pipelines_;
	std::vector<bool> computed_;
	std::vector<std::size_t> first_sets_;
	std::vector<VkDescriptorSet> layer_clear_sets_; // null where the layer is not computed
	std::vector<VkDescriptorSet> page_sets_;        // in the order of sheets and their pages
	bool knows_edges_ = false;                      // the polygons near edges are listed
	std::vector<Drawn> drawn_;                      // per layer; empty: they hold nothing yet
};

} // namespace vp::render
