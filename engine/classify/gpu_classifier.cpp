#include "classify/gpu_classifier.h"

#include "base/timeline.h"
#include "classify/gpu_lane.h"
#include "classify/gpu_workspace.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace vp::classify
{

GpuClassifier::GpuClassifier(GpuBlocks& blocks, std::vector<GpuLane> lanes, Timeline* timeline)
    : blocks_(blocks), lanes_(std::move(lanes)), timeline_(timeline), lane_cells_(lanes_.size(), 0)
{
	const VkPhysicalDeviceLimits& limits = blocks.device().limits();
	lane_stride_ = roundUp(sizeof(shared::ClassifyLane), limits.minUniformBufferOffsetAlignment);
	const std::size_t alignment = std::max<std::size_t>(limits.minStorageBufferOffsetAlignment, 4);
	word_alignment_ = alignment / 4;
	record_alignment_ = static_cast<std::uint32_t>(alignment / std::gcd(alignment, sizeof(shared::PolygonRecord)));
}

Result<std::unique_ptr<GpuClassifier>> GpuClassifier::create(GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
                                                             std::span<const std::optional<grid::FieldChoice>> fields,
                                                             std::vector<GpuLane> lanes, Timeline* timeline)
{
	std::unique_ptr<GpuClassifier> made(new GpuClassifier(blocks, std::move(lanes), timeline));
	Result<GpuBlocks::Fields> values = blocks.fields(fields);
	if (!values)
		return values.error();
	made->fields_ = std::move(*values);
	if (Status prepared = made->prepare(sheets); !prepared)
		return prepared.error();
	return made;
}

GpuClassifier::~GpuClassifier()
{
	finish();
}

Status GpuClassifier::prepare(std::span<const probe::Sheet> sheets)
{
	std::size_t axis_texels = 1;
	for (const GpuLane& lane : lanes_)
	{
		const grid::Block& block = blocks_.blocks().blocks[lane.block];
		cpu_lanes_.push_back({&block, sheets[lane.sheet].plane(), nullptr, {}});
		if (blocks_.holds(lane.block))
			axis_texels += axisTexels(block.grid);
	}
	for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet)
	{
		records_.push_back(std::make_shared<SheetRecords>(blocks_.recordPool()));
		records_.back()->overlapping = mayOverlap(blocks_.blocks());
	}
	if (blocks_.heldCount() == 0 || sheets.empty())
		return Nothing{};

	workspace_ = blocks_.borrowWorkspace();
	gpu::Device& device = blocks_.device();
	std::size_t held = 0;
	while (!blocks_.holds(held))
		++held;
	// The descriptor sets of all the pipelines are alike.
	if (Status done = workspace_->prepare(device, blocks_.pipeline(blocks_.block(held), fields_.front()->blocks[held]));
	    !done)
		return done;
	if (Status done = workspace_->reserveLanes(device, lanes_.size() * lane_stride_); !done)
		return done;
	if (Status done = workspace_->reserveAxes(device, axis_texels); !done)
		return done;

	const std::span<AxisTexel> axes(workspace_->axes.mappedAs<AxisTexel>(), axis_texels);
	std::size_t axis_start = 0;
	for (std::size_t l = 0; l < lanes_.size(); ++l)
	{
		const GpuLane& lane = lanes_[l];
		if (!blocks_.holds(lane.block))
			continue;
		const grid::Block& block = blocks_.blocks().blocks[lane.block];
		const std::size_t texels = axisTexels(block.grid);
		const GpuField& field = *fields_[lane.sheet];
		const shared::ClassifyLane described =
		    describeLane(block, blocks_.block(lane.block), field.blocks[lane.block], field.choice.has_value(),
		                 blocks_.usesDoubles(), sheets[lane.sheet], axis_start, axes.subspan(axis_start, texels));
		std::memcpy(workspace_->lanes.mappedAs<std::byte>() + l * lane_stride_, &described, sizeof(described));
		axis_start += texels;
	}
	return Nothing{};
}

Status GpuClassifier::classify(std::span<const find::FrontSlice> fronts)
{
	if (Status planned = planRuns(fronts); !planned)
		return planned;
	if (!runs_.empty())
	{
		auto* cells = workspace_->front.mappedAs<CellId>();
		for (const Run& run : runs_)
			std::memcpy(cells + run.offset, run.front->cells.data() + run.begin, run.count * sizeof(CellId));
		if (Status recorded = record(); !recorded)
			return recorded;
		if (Result<std::uint64_t> submitted = workspace_->commands.submit(); !submitted)
			return submitted.error();
	}
	// While the device works.
	CpuClassifier<surface::Plane> cpu(cpu_lanes_);
	if (Status done = cpu.classify(cpu_fronts_); !done)
		return done;
	if (runs_.empty())
		return Nothing{};

	return workspace_->takeWords(runs_);
}

Status GpuClassifier::planRuns(std::span<const find::FrontSlice> fronts)
{
	runs_.clear();
	cpu_fronts_.clear();
	std::size_t offset = 0;
	for (const find::FrontSlice& front : fronts)
	{
		if (!blocks_.holds(lanes_[front.lane].block))
			cpu_fronts_.push_back(front);
		else if (Status added = addRuns(front, offset); !added)
			return added;
	}
	return runs_.empty() ? Status(Nothing{}) : workspace_->reserveFront(blocks_.device(), offset);
}

Status GpuClassifier::addRuns(const find::FrontSlice& front, std::size_t& offset)
{
	const GpuLane& lane = lanes_[front.lane];
	SheetRecords& records = *records_[lane.sheet];
	const std::uint32_t capacity = records.pool->pageRecords();
	for (std::size_t begin = 0; begin < front.cells.size();)
	{
		std::size_t first = records.pages.empty() ? capacity : roundUp(records.pages.back().count, record_alignment_);
		if (first >= capacity)
		{
			Result<std::shared_ptr<RecordPage>> page = records.pool->take(RecordPool::Writer::gpu);
			if (!page)
				return page.error();
			records.pages.push_back({std::move(*page), 0});
			first = 0;
		}
		SheetRecords::Page& page = records.pages.back();
		const std::size_t count = std::min(front.cells.size() - begin, capacity - first);
		const std::size_t padded = std::min(roundUp(count, record_alignment_), capacity - first);
		runs_.push_back({&front, begin, count, offset, page.buffer(), static_cast<std::uint32_t>(first),
		                 static_cast<std::uint32_t>(padded)});
		records.runs.push_back({static_cast<std::uint32_t>(records.pages.size() - 1), static_cast<std::uint32_t>(first),
		                        static_cast<std::uint32_t>(count), lane.block, lane_cells_[front.lane]});
		page.count = static_cast<std::uint32_t>(first + count);
		lane_cells_[front.lane] += static_cast<std::uint32_t>(count);
		begin += count;
		offset += roundUp(count, word_alignment_);
	}
	return Nothing{};
}

Status GpuClassifier::record()
{
	Result<VkCommandBuffer> begun = workspace_->commands.begin();
	if (!begun)
		return begun.error();
	const VkCommandBuffer commands = *begun;
	std::optional<gpu::TimedPass> timed; // labels the pass as well
	std::optional<gpu::Label> label;
	if (timeline_)
		timed.emplace(workspace_->timers, commands, "classify");
	else
		label.emplace(blocks_.device(), commands, "classify");
	// The pages may still be drawn from by work submitted before.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE,
	                   VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE);
	for (std::size_t i = 0; i < runs_.size(); ++i)
	{
		Result<VkDescriptorSet> set = workspace_->sets.get(i);
		if (!set)
			return set.error();
		recordRun(commands, runs_[i], *set);
	}
	// Words to the host, records to whatever draws them.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT | VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
	                   VK_ACCESS_2_HOST_READ_BIT | VK_ACCESS_2_MEMORY_READ_BIT);
	return Nothing{};
}

void GpuClassifier::recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set)
{
	const GpuLane& lane = lanes_[run.front->lane];
	const GpuBlock& block = blocks_.block(lane.block);
	const GpuValues& values = fields_[lane.sheet]->blocks[lane.block];
	const auto orCases = [&](const GpuTexels& texels) { return texels ? texels.view.handle() : blocks_.caseTexels(); };

	// Descriptors cover what the run touches and no more, so runs of a generation need no barrier between them.
	gpu::DescriptorWriter writer;
	writer.texels(shared::kBindPoints, orCases(block.points))
	    .texels(shared::kBindCells, orCases(block.cells))
	    .texels(shared::kBindCases, blocks_.caseTexels())
	    .texels(shared::kBindValues, values.texels ? values.texels.view.handle() : blocks_.noValueTexels())
	    .texels(shared::kBindAxes, workspace_->axis_texels.handle())
	    .storageBuffer(shared::kBindFront, workspace_->front.handle(), 4 * run.offset, 4 * run.count)
	    .storageBuffer(shared::kBindWords, workspace_->words.handle(), 4 * run.offset, 4 * run.count)
	    .storageBuffer(shared::kBindRecords, run.page, run.first * sizeof(shared::PolygonRecord),
	                   run.padded * sizeof(shared::PolygonRecord))
	    .uniformBuffer(shared::kBindLane, workspace_->lanes.handle(), run.front->lane * lane_stride_,
	                   sizeof(shared::ClassifyLane))
	    .write(blocks_.device(), set);

	const gpu::Pipeline& pipeline = blocks_.pipeline(block, values);
	pipeline.bind(commands, set);
	pipeline.push(commands, shared::ClassifyPush{static_cast<std::uint32_t>(run.count), run.padded});
	vkCmdDispatch(commands, (run.padded + shared::kClassifyGroupSize - 1) / shared::kClassifyGroupSize, 1, 1);
}

std::vector<std::shared_ptr<SheetRecords>> GpuClassifier::finish()
{
	if (workspace_)
	{
		if (workspace_->commands.handle() && workspace_->commands.wait() && timeline_)
			workspace_->timers.collect(*timeline_);
		blocks_.giveBack(std::move(workspace_));
	}
	return std::move(records_);
}

} // namespace vp::classify
