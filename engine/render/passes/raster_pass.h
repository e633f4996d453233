#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/passes/targets.h"
#include "render/scene/scene.h"
#include "shared/render_types.h"

#include <map>
#include <span>
#include <vector>

namespace vp::render
{

// Draws small polygons into layers of values with a compute shader (render_raster.comp). Polygons that are too large
// for it, or reach the near plane, are listed for the rasterizer of the hardware. For polygons of about a pixel the
// rasterizer takes several times as long, at least on a software device.
class RasterPass
{
public:
	static Result<RasterPass> create(gpu::Device& device);

	// Room for the pages of those sheets; before recording, while no submission draws.
	Status prepare(const Scene& scene, const Targets& targets, const std::vector<bool>& computed);
	// Empty lists; transfers, to be seen by what record() does.
	void recordStart(VkCommandBuffer commands) const;
	// A sheet's polygons of up to `side` pixels into its layer, which is empty, in the general layout.
	void record(VkCommandBuffer commands, const Scene& scene, std::size_t sheet, VkExtent2D extent,
	            const glm::dvec2& jitter, std::uint32_t side) const;

	// What is drawn at once: records of one page and one part (SheetRecords::parts).
	struct Run
	{
		std::size_t page;
		std::uint32_t first;
		std::uint32_t count;
		std::uint32_t listed_from; // where in the list the numbers of its large polygons begin
		std::uint32_t draw;        // which of the draws is theirs
		bool begins_part;          // after the first one
		VkDescriptorSet set;
	};
	// For the hardware.
	VkBuffer list() const { return list_.handle(); }
	VkBuffer draws() const { return draws_.handle(); }
	std::span<const Run> runs(std::size_t sheet) const
	{
		return std::span(runs_).subspan(first_runs_[sheet], first_runs_[sheet + 1] - first_runs_[sheet]);
	}

private:
	void addRuns(const classify::SheetRecords& records);
	Status makeSets(const Scene& scene, const Targets& targets);

	Result<const gpu::Pipeline*> pipelineFor(std::uint32_t features); // made on first use

	gpu::Device* device_ = nullptr;
	std::map<std::uint32_t, gpu::Pipeline> pipelines_;
	gpu::DescriptorSets sets_;
	gpu::Buffer list_;  // numbers of records, a stretch a run
	gpu::Buffer draws_; // shared::RasterDraw a run
	// Of the scene prepared last.
	std::vector<Run> runs_;
	std::vector<std::size_t> first_runs_;               // per sheet, and the end
	std::vector<const gpu::Pipeline*> sheet_pipelines_; // per sheet; null where it is not drawn here
};

} // namespace vp::render
