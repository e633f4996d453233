#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/passes/edge_tiles.h"
#include "render/passes/targets.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <array>
#include <map>
#include <span>
#include <vector>

namespace vp::render
{

// Draws polygons into layers of values with a compute shader (render_raster.comp), in its three stages. For polygons of
// about a pixel, and for long thin ones, the rasterizer of a software device takes many times as long.
class RasterPass
{
public:
	static Result<RasterPass> create(gpu::Device& device);

	// Room for the pages of those sheets; before recording, while no submission draws. edges: null for a picture of one
	// sample.
	Status prepare(const Scene& scene, const Targets& targets, const std::vector<bool>& computed,
	               const EdgeTiles* edges);
	// Empty lists; transfers, to be seen by what record() does.
	void recordStart(VkCommandBuffer commands) const;
	// The polygons of those sheets into their layers, which are empty, in the general layout. One thread draws a
	// polygon of up to `side` pixels. only_kept: draws the polygons that recordKept() has listed, and no others.
	struct Drawing
	{
		PicturePart part;
		glm::dvec2 jitter;
		std::uint32_t side;
		bool only_kept;
	};
	void record(VkCommandBuffer commands, const Scene& scene, std::span<const std::size_t> sheets,
	            const Drawing& drawing) const;
	// Lists the polygons near the edges of a picture whose first sample was drawn.
	void recordKept(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const;

private:
	// The records that are drawn at once. They belong to one page and one part (SheetRecords::parts).
	struct Run
	{
		std::size_t page;
		std::uint32_t first;
		std::uint32_t count;
		std::uint32_t listed_from; // where in the list the numbers of its polygons begin
		std::uint32_t lists;       // which of the RasterLists are its own, one a later stage
		std::uint32_t kept_list;   // and which is that of the polygons near edges
		std::uint32_t kept_from;   // where in the list their numbers begin
		std::size_t part;          // from 0 on for each sheet
		VkDescriptorSet set;
	};
	using Stages = std::array<const gpu::Pipeline*, shared::kRasterStages>;

	void addRuns(const classify::SheetRecords& records);
	Status makeSets(const Scene& scene, const Targets& targets, const EdgeTiles* edges);
	std::span<const Run> runs(std::size_t sheet) const
	{
		return std::span(runs_).subspan(first_runs_[sheet], first_runs_[sheet + 1] - first_runs_[sheet]);
	}
	void recordEmpty(VkCommandBuffer commands, std::size_t first, const std::vector<shared::RasterList>& lists) const;
	void recordRun(VkCommandBuffer commands, const Run& run, const Stages& pipelines, std::uint32_t stage,
	               shared::RasterPush& push) const;

	// Made on first use. keeps: with the stages of later samples.
	Result<Stages> pipelinesFor(std::uint32_t features, bool keeps);

	gpu::Device* device_ = nullptr;
	std::map<std::uint32_t, std::array<gpu::Pipeline, shared::kRasterStages>> pipelines_; // by their features
	gpu::DescriptorSets sets_;
	gpu::Buffer list_;  // numbers of records, a stretch a run; then those near edges
	gpu::Buffer lists_; // shared::RasterList, two a run; then those of the polygons near edges
	// The scene prepared last.
	std::vector<Run> runs_;
	std::vector<std::size_t> first_runs_; // per sheet, and the end
	std::vector<Stages> sheet_pipelines_; // per sheet; null where it is not drawn here
};

} // namespace vp::render
