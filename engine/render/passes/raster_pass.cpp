#include "gpu/vulkan.h"

#include "render/passes/raster_pass.h"

#include "classify/gpu_records.h"
#include "gpu/commands.h"
#include "render/passes/picture_geometry.h"

#include <algorithm>

namespace vp::render
{

static_assert(sizeof(shared::RasterPush) == 120 && sizeof(shared::RasterDraw) == sizeof(VkDrawIndexedIndirectCommand));

namespace
{

// vkCmdUpdateBuffer takes so many bytes.
constexpr std::size_t kMaxUpdate = 65536 / sizeof(shared::RasterDraw);

Status makeDeviceRoom(gpu::Device& device, gpu::Buffer& buffer, VkDeviceSize bytes, VkBufferUsageFlags usage,
                      const char* name)
{
	if (buffer && buffer.size() >= bytes)
		return Nothing{};
	auto made =
	    gpu::Buffer::create(device, std::max<VkDeviceSize>(bytes + bytes / 2, 1024), usage, gpu::Memory::device, name);
	if (!made)
		return made.error();
	buffer = std::move(*made);
	return Nothing{};
}

} // namespace

Result<RasterPass> RasterPass::create(gpu::Device& device)
{
	RasterPass pass;
	pass.device_ = &device;
	auto first = pass.pipelineFor(0);
	if (!first)
		return first.error();
	pass.sets_ = gpu::DescriptorSets(device, **first, "raster");
	return pass;
}

Result<const gpu::Pipeline*> RasterPass::pipelineFor(std::uint32_t features)
{
	gpu::Pipeline& pipeline = pipelines_[features];
	if (pipeline)
		return &pipeline;
	gpu::ComputePipelineInfo info;
	info.shader = "render_raster.comp";
	info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
	                 {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
	                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
	                 {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER}};
	info.push_bytes = sizeof(shared::RasterPush);
	info.constants = {{0, features}};
	auto made = gpu::Pipeline::create(*device_, info, "raster");
	if (!made)
		return made.error();
	pipeline = std::move(*made);
	return &pipeline;
}

// A sheet's records, parted where pages and parts end.
void RasterPass::addRuns(const classify::SheetRecords& records)
{
	std::uint32_t listed = runs_.empty() ? 0 : runs_.back().listed_from + runs_.back().count;
	std::size_t page_start = 0;
	auto part = records.parts.begin();
	for (std::size_t page = 0; page < records.pages.size(); ++page)
	{
		const std::uint32_t count = records.pages[page].count;
		for (std::uint32_t first = 0; first < count;)
		{
			bool begins_part = false;
			for (; part != records.parts.end() && *part <= page_start + first; ++part)
				begins_part = true;
			const std::uint32_t end =
			    part == records.parts.end()
			        ? count
			        : static_cast<std::uint32_t>(std::min<std::size_t>(count, *part - page_start));
			const auto draw = static_cast<std::uint32_t>(runs_.size());
			runs_.push_back({page, first, end - first, listed, draw, begins_part, VK_NULL_HANDLE});
			listed += end - first;
			first = end;
		}
		page_start += count;
	}
}

Status RasterPass::prepare(const Scene& scene, const Targets& targets, const std::vector<bool>& computed)
{
	runs_.clear();
	first_runs_.assign(1, 0);
	sheet_pipelines_.clear();
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		sheet_pipelines_.push_back(nullptr);
		if (computed[s])
		{
			auto pipeline = pipelineFor(scene.sheets[s].window ? shared::kLayerWindow : 0u);
			if (!pipeline)
				return pipeline.error();
			sheet_pipelines_.back() = *pipeline;
			addRuns(*scene.sheets[s].records);
		}
		first_runs_.push_back(runs_.size());
	}
	const VkDeviceSize listed = runs_.empty() ? 0 : runs_.back().listed_from + runs_.back().count;
	if (Status room = makeDeviceRoom(*device_, list_, sizeof(std::uint32_t) * listed,
	                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "large polygons");
	    !room)
		return room;
	if (Status room = makeDeviceRoom(*device_, draws_, sizeof(shared::RasterDraw) * runs_.size(),
	                                 VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
	                                     VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                                 "draws of large polygons");
	    !room)
		return room;
	return makeSets(scene, targets);
}

Status RasterPass::makeSets(const Scene& scene, const Targets& targets)
{
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
		for (std::size_t r = first_runs_[s]; r < first_runs_[s + 1]; ++r)
		{
			const bool same_page = r > first_runs_[s] && runs_[r - 1].page == runs_[r].page;
			if (same_page)
			{
				runs_[r].set = runs_[r - 1].set;
				continue;
			}
			auto set = sets_.get(r);
			if (!set)
				return set.error();
			runs_[r].set = *set;
			gpu::DescriptorWriter()
			    .texels(0, scene.sheets[s].records->pages[runs_[r].page].texels())
			    .storageImage(1, targets.layer(s))
			    .storageBuffer(2, list_.handle())
			    .storageBuffer(3, draws_.handle())
			    .write(*device_, *set);
		}
	return Nothing{};
}

void RasterPass::recordStart(VkCommandBuffer commands) const
{
	const std::vector<shared::RasterDraw> none(std::min(runs_.size(), kMaxUpdate), {0, 1, 0, 0, 0});
	for (std::size_t first = 0; first < runs_.size(); first += kMaxUpdate)
		vkCmdUpdateBuffer(commands, draws_.handle(), sizeof(none[0]) * first,
		                  sizeof(none[0]) * std::min(kMaxUpdate, runs_.size() - first), none.data());
}

void RasterPass::record(VkCommandBuffer commands, const Scene& scene, std::size_t sheet, VkExtent2D extent,
                        const glm::dvec2& jitter, std::uint32_t side) const
{
	shared::RasterPush push = rasterPush(scene.sheets[sheet], scene.camera, extent, jitter);
	push.largest = static_cast<float>(std::min(side, shared::kMaxRasterSide) * shared::kSubpixels);
	const gpu::Pipeline& pipeline = *sheet_pipelines_[sheet];
	for (const Run& run : runs(sheet))
	{
		if (run.begins_part)
			gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
			                   VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
		push.first = run.first;
		push.count = run.count;
		push.draw = run.draw;
		push.listed_from = run.listed_from;
		pipeline.bind(commands, run.set);
		pipeline.push(commands, push);
		vkCmdDispatch(commands, (run.count + shared::kRasterGroupSize - 1) / shared::kRasterGroupSize, 1, 1);
	}
}

} // namespace vp::render
