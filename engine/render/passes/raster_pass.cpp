#include "gpu/vulkan.h"

#include "render/passes/raster_pass.h"

#include "classify/gpu_records.h"
#include "gpu/commands.h"
#include "render/passes/buffers.h"
#include "render/passes/picture_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render
{

static_assert(sizeof(shared::RasterPush) == 128 &&
              sizeof(shared::RasterList::groups) == sizeof(VkDispatchIndirectCommand));

namespace
{

// vkCmdUpdateBuffer takes so many bytes.
constexpr std::size_t kMaxUpdate = 65536 / sizeof(shared::RasterList);

constexpr std::uint32_t kLists = shared::kRasterLists;

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkAccessFlags2 kWrites = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;

// Returns false if no polygon of a sheet can be one for the last stage: none covers more than kHugeArea pixels, and all
// lie before the near plane and not far outside of the picture. Software compiles a stage when it first runs, and this
// one takes it longer than all others.
bool mayBeHuge(const classify::SheetRecords& records, const shared::RasterPush& push)
{
	constexpr double kSure = 0.5;
	if (!records.bounds || !records.longest)
		return true;
	const auto row = [](const float(&r)[3]) { return glm::dvec3(r[0], r[1], r[2]); };
	const glm::dvec3 u_axis = row(push.u_axis), v_axis = row(push.v_axis), origin = row(push.origin);
	double least_w = std::numeric_limits<double>::infinity();
	double farthest = 0.0;
	const mesh::UvBounds& bounds = *records.bounds;
	for (const double u : {bounds.lo.x, bounds.hi.x})
		for (const double v : {bounds.lo.y, bounds.hi.y})
		{
			const glm::dvec3 at = u * u_axis + v * v_axis + origin;
			least_w = std::min(least_w, at.z);
			farthest = std::max(farthest, std::max(std::abs(at.x), std::abs(at.y)) / at.z);
		}
	if (!(least_w > push.near_w / kSure && farthest < kSure * shared::kFarOutside))
		return true;
	// The derivative of a place, (x, y) / w, by u is at most (|axis.xy| + |place| |axis.z|) / w.
	const auto most = [&](const glm::dvec3& axis)
	{ return (glm::length(glm::dvec2(axis)) + 2.0 * farthest * std::abs(axis.z)) / least_w; };
	const double side = *records.longest * std::hypot(most(u_axis), most(v_axis)) / shared::kSubpixels;
	return !(side * side < kSure * shared::kHugeArea);
}

} // namespace

Result<RasterPass> RasterPass::create(gpu::Device& device)
{
	RasterPass pass;
	pass.device_ = &device;
	auto first = pass.pipelinesFor(0, false);
	if (!first)
		return first.error();
	pass.sets_ = gpu::DescriptorSets(device, *first->front(), "raster");
	return pass;
}

Result<RasterPass::Stages> RasterPass::pipelinesFor(std::uint32_t features, bool keeps)
{
	auto& pipelines = pipelines_[features];
	Stages stages{};
	for (std::uint32_t stage = 0; stage < (keeps ? shared::kRasterStages : shared::kRasterKeep); ++stage)
	{
		stages[stage] = &pipelines[stage];
		if (pipelines[stage])
			continue;
		gpu::ComputePipelineInfo info;
		info.shader = "render_raster.comp";
		info.bindings = {{0, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER},
		                 {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
		                 {2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
		                 {3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
		                 {4, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER}};
		info.push_bytes = sizeof(shared::RasterPush);
		info.constants = {{0, features}, {1, stage}};
		auto made = gpu::Pipeline::create(*device_, info, "raster");
		if (!made)
			return made.error();
		pipelines[stage] = std::move(*made);
	}
	return stages;
}

// A sheet's records, parted where pages and parts end.
void RasterPass::addRuns(const classify::SheetRecords& records)
{
	std::uint32_t listed = runs_.empty() ? 0 : runs_.back().listed_from + runs_.back().count;
	std::size_t page_start = 0;
	auto part = records.parts.begin();
	std::size_t parts_begun = 0;
	for (std::size_t page = 0; page < records.pages.size(); ++page)
	{
		const std::uint32_t count = records.pages[page].count;
		for (std::uint32_t first = 0; first < count;)
		{
			for (; part != records.parts.end() && *part <= page_start + first; ++part)
				++parts_begun;
			const std::uint32_t end =
			    part == records.parts.end()
			        ? count
			        : static_cast<std::uint32_t>(std::min<std::size_t>(count, *part - page_start));
			const auto lists = static_cast<std::uint32_t>(kLists * runs_.size());
			runs_.push_back({page, first, end - first, listed, lists, 0, 0, parts_begun, VK_NULL_HANDLE});
			listed += end - first;
			first = end;
		}
		page_start += count;
	}
}

Status RasterPass::prepare(const Scene& scene, const Targets& targets, const std::vector<bool>& computed,
                           const EdgeTiles* edges)
{
	runs_.clear();
	first_runs_.assign(1, 0);
	sheet_pipelines_.clear();
	for (std::size_t s = 0; s < scene.sheets.size(); ++s)
	{
		sheet_pipelines_.push_back({});
		if (computed[s])
		{
			auto pipelines = pipelinesFor(scene.sheets[s].window ? shared::kLayerWindow : 0u, edges != nullptr);
			if (!pipelines)
				return pipelines.error();
			sheet_pipelines_.back() = *pipelines;
			addRuns(*scene.sheets[s].records);
		}
		first_runs_.push_back(runs_.size());
	}
	const std::uint32_t listed = runs_.empty() ? 0 : runs_.back().listed_from + runs_.back().count;
	for (std::size_t r = 0; r < runs_.size(); ++r)
	{
		runs_[r].kept_list = static_cast<std::uint32_t>(kLists * runs_.size() + r);
		runs_[r].kept_from = listed + runs_[r].listed_from;
	}
	if (Status room = makeRoom(*device_, list_, sizeof(std::uint32_t) * 2 * VkDeviceSize(listed),
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "polygons of later stages", gpu::Memory::device);
	    !room)
		return room;
	if (Status room = makeRoom(*device_, lists_, sizeof(shared::RasterList) * (kLists + 1) * runs_.size(),
	                           VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
	                               VK_BUFFER_USAGE_TRANSFER_DST_BIT,
	                           "lists of later stages", gpu::Memory::device);
	    !room)
		return room;
	return makeSets(scene, targets, edges);
}

Status RasterPass::makeSets(const Scene& scene, const Targets& targets, const EdgeTiles* edges)
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
			const VkBufferView records = scene.sheets[s].records->pages[runs_[r].page].texels();
			gpu::DescriptorWriter()
			    .texels(0, records)
			    .storageImage(1, targets.layer(s))
			    .storageBuffer(2, list_.handle())
			    .storageBuffer(3, lists_.handle())
			    .texels(4, edges ? edges->texels() : records)
			    .write(*device_, *set);
		}
	return Nothing{};
}

// Writes lists in which there is nothing, from number `first` on.
void RasterPass::recordEmpty(VkCommandBuffer commands, std::size_t first,
                             const std::vector<shared::RasterList>& lists) const
{
	for (std::size_t i = 0; i < lists.size(); i += kMaxUpdate)
		vkCmdUpdateBuffer(commands, lists_.handle(), sizeof(lists[0]) * (first + i),
		                  sizeof(lists[0]) * std::min(kMaxUpdate, lists.size() - i), &lists[i]);
}

void RasterPass::recordStart(VkCommandBuffer commands) const
{
	std::vector<shared::RasterList> none(kLists * runs_.size());
	for (std::size_t i = 0; i < none.size(); ++i)
	{
		const bool is_huge = i % kLists == shared::kRasterHuge - 1;
		none[i] = {{0, is_huge ? shared::kRasterBands : 1u, 1}, 0};
	}
	recordEmpty(commands, 0, none);
}

void RasterPass::recordKept(VkCommandBuffer commands, const Scene& scene, const PicturePart& part) const
{
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | kCompute, VK_ACCESS_2_NONE, gpu::kUpdateStages,
	                   VK_ACCESS_2_NONE);
	recordEmpty(commands, kLists * runs_.size(), std::vector<shared::RasterList>(runs_.size(), {{0, 1, 1}, 0}));
	gpu::memoryBarrier(commands, gpu::kUpdateStages, VK_ACCESS_2_TRANSFER_WRITE_BIT, kCompute,
	                   VK_ACCESS_2_SHADER_STORAGE_READ_BIT | kWrites);
	for (std::size_t sheet = 0; sheet < sheet_pipelines_.size(); ++sheet)
	{
		if (runs(sheet).empty())
			continue;
		shared::RasterPush push = rasterPush(scene.sheets[sheet], scene.camera, part, {0.0, 0.0});
		for (const Run& run : runs(sheet))
			recordRun(commands, run, sheet_pipelines_[sheet], shared::kRasterKeep, push);
	}
	gpu::memoryBarrier(commands, kCompute, kWrites, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | kCompute,
	                   VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
}

void RasterPass::recordRun(VkCommandBuffer commands, const Run& run, const Stages& pipelines, std::uint32_t stage,
                           shared::RasterPush& push) const
{
	push.first = run.first;
	push.count = run.count;
	push.lists = run.lists;
	push.listed_from = run.listed_from;
	push.kept_list = run.kept_list;
	push.kept_from = run.kept_from;
	pipelines[stage]->bind(commands, run.set);
	pipelines[stage]->push(commands, push);
	if (stage == shared::kRasterSmall || stage == shared::kRasterKeep)
		return vkCmdDispatch(commands, (run.count + shared::kRasterGroupSize - 1) / shared::kRasterGroupSize, 1, 1);
	const std::uint32_t list = stage == shared::kRasterKept ? run.kept_list : run.lists + stage - 1;
	vkCmdDispatchIndirect(commands, lists_.handle(), sizeof(shared::RasterList) * list);
}

void RasterPass::record(VkCommandBuffer commands, const Scene& scene, std::span<const std::size_t> sheets,
                        const Drawing& drawing) const
{
	std::vector<shared::RasterPush> pushes;
	std::vector<bool> may_be_huge;
	std::size_t parts = 0;
	for (const std::size_t sheet : sheets)
	{
		pushes.push_back(rasterPush(scene.sheets[sheet], scene.camera, drawing.part, drawing.jitter));
		may_be_huge.push_back(scene.sheets[sheet].records && mayBeHuge(*scene.sheets[sheet].records, pushes.back()));
		pushes.back().largest = static_cast<float>(std::min(drawing.side, shared::kMaxRasterSide) * shared::kSubpixels);
		if (!runs(sheet).empty())
			parts = std::max(parts, runs(sheet).back().part + 1);
	}
	const auto recordStage = [&](std::uint32_t stage, std::size_t part)
	{
		for (std::size_t i = 0; i < sheets.size(); ++i)
			for (const Run& run : runs(sheets[i]))
				if (run.part == part && (stage != shared::kRasterHuge || may_be_huge[i]))
					recordRun(commands, run, sheet_pipelines_[sheets[i]], stage, pushes[i]);
	};
	for (std::size_t part = 0; part < parts; ++part)
	{
		// A later part covers earlier ones.
		if (part > 0)
			gpu::memoryBarrier(commands, kCompute, kWrites, kCompute, kWrites);
		recordStage(drawing.only_kept ? shared::kRasterKept : shared::kRasterSmall, part);
		gpu::memoryBarrier(commands, kCompute, kWrites, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT | kCompute,
		                   VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
		recordStage(shared::kRasterLarge, part);
		recordStage(shared::kRasterHuge, part);
	}
}

} // namespace vp::render
