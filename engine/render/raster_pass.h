#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "render/scene.h"
#include "render/targets.h"
#include "shared/render_types.h"

#include <map>
#include <vector>

namespace vp::render
{

// Draws small polygons into layers of values with a compute shader (render_raster.comp), and lists those that are too
// large for it, or reach the near plane, for the hardware's rasterizer. Where polygons are about a pixel large the
// hardware's way costs several times as much, on a software device at least.
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

	// For the hardware: where the numbers of a page's records begin in the list, and the draw of so many.
	VkBuffer list() const { return list_.handle(); }
	VkBuffer draws() const { return draws_.handle(); }
	std::uint32_t listedFrom(std::size_t sheet, std::size_t page) const
	{
		return pages_[first_pages_[sheet] + page].listed_from;
	}
	VkDeviceSize drawOffset(std::size_t sheet, std::size_t page) const
	{
		return sizeof(shared::RasterDraw) * (first_pages_[sheet] + page);
	}

private:
	struct Page
	{
		std::uint32_t listed_from;
		VkDescriptorSet set;
	};

	Result<const gpu::Pipeline*> pipelineFor(std::uint32_t features); // made on first use

	gpu::Device* device_ = nullptr;
	std::map<std::uint32_t, gpu::Pipeline> pipelines_;
	gpu::DescriptorSets sets_;
	gpu::Buffer list_;  // numbers of records, a part a page
	gpu::Buffer draws_; // shared::RasterDraw a page
	std::vector<Page> pages_;
	std::vector<std::size_t> first_pages_;              // per sheet of the scene prepared last
	std::vector<const gpu::Pipeline*> sheet_pipelines_; // likewise; null where it is not drawn here
};

} // namespace vp::render
