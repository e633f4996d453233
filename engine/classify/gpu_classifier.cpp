#include "classify/gpu_classifier.h"

#include "base/timeline.h"
#include "classify/gpu_workspace.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>

namespace vp::classify
{

namespace
{

// Cells in a dispatch without records: 2^14 groups. Every device takes at least 65 535.
constexpr std::size_t kMaxRun = std::size_t(shared::kClassifyGroupSize) << 14;

} // namespace

GpuClassifier::GpuClassifier(GpuBlocks& blocks, std::vector<GpuSheetInBlock> sheets, OnCpu on_cpu, Timeline* timeline)
    : blocks_(blocks), sheets_(std::move(sheets)), on_cpu_(std::move(on_cpu)), timeline_(timeline),
      cells_done_(sheets_.size(), 0)
{
	const VkPhysicalDeviceLimits& limits = blocks.device().limits();
	told_stride_ = roundUp(GpuSheetInBlock::kMaxTold, limits.minUniformBufferOffsetAlignment);
	const std::size_t alignment = std::max<std::size_t>(limits.minStorageBufferOffsetAlignment, 4);
	code_alignment_ = alignment / 4;
	record_alignment_ = static_cast<std::uint32_t>(alignment / std::gcd(alignment, sizeof(shared::PolygonRecord)));
}

Result<std::unique_ptr<GpuClassifier>> GpuClassifier::create(GpuBlocks& blocks, std::vector<GpuSheetInBlock> sheets,
                                                             OnCpu on_cpu, Timeline* timeline)
{
	std::unique_ptr<GpuClassifier> made(new GpuClassifier(blocks, std::move(sheets), std::move(on_cpu), timeline));
	if (Status prepared = made->prepare(); !prepared)
		return prepared.error();
	return made;
}

GpuClassifier::~GpuClassifier()
{
	if (!workspace_)
		return;
	try
	{
		if (workspace_->commands.handle() && workspace_->commands.wait() && timeline_)
			workspace_->timers.collect(*timeline_);
		blocks_.giveBack(std::move(workspace_));
	}
	catch (const std::bad_alloc&)
	{
		// The times are lost, and so may the workspace be: another one is made.
	}
}

Status GpuClassifier::prepare()
{
	std::size_t axis_texels = 1;
	bool is_used = false;
	for (const GpuSheetInBlock& sheet : sheets_)
		if (sheet.pipeline)
		{
			is_used = true;
			axis_texels += axisTexels(blocks_.blocks().blocks[sheet.block].grid);
		}
	if (!is_used)
		return Nothing{};

	workspace_ = blocks_.borrowWorkspace();
	gpu::Device& device = blocks_.device();
	if (Status done = workspace_->prepare(device, blocks_.lastingPipeline()); !done)
		return done;
	if (Status done = workspace_->reserveSheets(device, sheets_.size() * told_stride_); !done)
		return done;
	if (Status done = workspace_->reserveAxes(device, axis_texels); !done)
		return done;

	const std::span<AxisTexel> axes(workspace_->axes.buffer().mappedAs<AxisTexel>(), axis_texels);
	std::size_t axis_start = 0;
	for (std::size_t i = 0; i < sheets_.size(); ++i)
	{
		if (!sheets_[i].pipeline)
			continue;
		const std::size_t texels = axisTexels(blocks_.blocks().blocks[sheets_[i].block].grid);
		sheets_[i].describe(axis_start, axes.subspan(axis_start, texels),
		                    workspace_->sheets.mappedAs<std::byte>() + i * told_stride_);
		axis_start += texels;
	}
	return Nothing{};
}

Status GpuClassifier::classify(std::span<const find::Front> fronts)
{
	if (Status planned = planRuns(fronts); !planned)
		return planned;
	if (!runs_.empty())
		if (Status submitted = submit(); !submitted)
			return submitted;
	// Done while the device works.
	if (!cpu_fronts_.empty())
		if (Status done = on_cpu_(cpu_fronts_); !done)
			return done;
	return runs_.empty() ? Status(Nothing{}) : workspace_->takeCodes(runs_);
}

Status GpuClassifier::planRuns(std::span<const find::Front> fronts)
{
	runs_.clear();
	cpu_fronts_.clear();
	std::size_t offset = 0;
	for (const find::Front& front : fronts)
	{
		if (!sheets_[front.sheet].pipeline)
			cpu_fronts_.push_back(front);
		else if (Status added = addRuns(front, offset); !added)
			return added;
	}
	return runs_.empty() ? Status(Nothing{}) : workspace_->reserveFront(blocks_.device(), offset);
}

Status GpuClassifier::addRuns(const find::Front& front, std::size_t& offset)
{
	for (std::size_t begin = 0; begin < front.cells.size();)
	{
		const std::size_t left = front.cells.size() - begin;
		Run run{&front, begin, std::min(left, kMaxRun), offset};
		if (sheets_[front.sheet].records)
			if (Status placed = placeRecords(front, begin, run); !placed)
				return placed;
		runs_.push_back(run);
		begin += run.count;
		offset += roundUp(run.count, code_alignment_);
	}
	return Nothing{};
}

// Takes the run's records from the end of the last page, or from a new one.
Status GpuClassifier::placeRecords(const find::Front& front, std::size_t begin, Run& run)
{
	SheetRecords& records = *sheets_[front.sheet].records;
	const std::uint32_t capacity = records.pool->pageRecords();
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
	run.count = std::min(front.cells.size() - begin, capacity - first);
	run.page = page.buffer();
	run.first = static_cast<std::uint32_t>(first);
	run.padded = static_cast<std::uint32_t>(std::min(roundUp(run.count, record_alignment_), capacity - first));
	records.runs.push_back({static_cast<std::uint32_t>(records.pages.size() - 1), run.first,
	                        static_cast<std::uint32_t>(run.count),
	                        static_cast<std::uint32_t>(sheets_[front.sheet].block), cells_done_[front.sheet]});
	page.count = static_cast<std::uint32_t>(first + run.count);
	cells_done_[front.sheet] += static_cast<std::uint32_t>(run.count);
	return Nothing{};
}

Status GpuClassifier::submit()
{
	auto* cells = workspace_->front.mappedAs<CellId>();
	for (const Run& run : runs_)
		std::memcpy(cells + run.offset, run.front->cells.data() + run.begin, run.count * sizeof(CellId));
	Result<VkCommandBuffer> commands = workspace_->commands.begin();
	if (!commands)
		return commands.error();
	if (Status recorded = record(*commands); !recorded)
		return recorded;
	Result<std::uint64_t> submitted = workspace_->commands.submit();
	return submitted ? Status(Nothing{}) : Status(submitted.error());
}

Status GpuClassifier::record(VkCommandBuffer commands)
{
	std::optional<gpu::TimedPass> timed; // labels the pass as well
	std::optional<gpu::Label> label;
	if (timeline_)
		timed.emplace(workspace_->timers, commands, "classify");
	else
		label.emplace(blocks_.device(), commands, "classify");
	// Earlier submissions may still draw from these pages.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_NONE,
	                   VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_NONE);
	for (std::size_t i = 0; i < runs_.size(); ++i)
	{
		Result<VkDescriptorSet> set = workspace_->sets.get(i);
		if (!set)
			return set.error();
		recordRun(commands, runs_[i], *set);
	}
	// Makes codes visible to the host, and records to drawing.
	gpu::memoryBarrier(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
	                   VK_PIPELINE_STAGE_2_HOST_BIT | VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
	                   VK_ACCESS_2_HOST_READ_BIT | VK_ACCESS_2_MEMORY_READ_BIT);
	return Nothing{};
}

void GpuClassifier::recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set)
{
	const GpuSheetInBlock& sheet = sheets_[run.front->sheet];
	const GpuBlock& block = blocks_.block(sheet.block);
	const auto orCases = [&](const gpu::ShaderArray& array) { return array ? array.place() : blocks_.cases(); };

	// Descriptors cover only what the run touches, so runs of a generation need no barrier between them.
	gpu::DescriptorWriter writer;
	writer.array(shared::kBindPoints, orCases(block.points))
	    .array(shared::kBindCells, orCases(block.cells))
	    .array(shared::kBindCases, blocks_.cases())
	    .array(shared::kBindValues, sheet.values ? sheet.values : blocks_.noValues())
	    .array(shared::kBindAxes, workspace_->axes.place())
	    .storageBuffer(shared::kBindFront, workspace_->front.handle(), 4 * run.offset, 4 * run.count)
	    .storageBuffer(shared::kBindCodes, workspace_->codes.handle(), 4 * run.offset, 4 * run.count)
	    .uniformBuffer(shared::kBindSheet, workspace_->sheets.handle(), run.front->sheet * told_stride_,
	                   GpuSheetInBlock::kMaxTold);
	if (run.page)
		writer.storageBuffer(shared::kBindRecords, run.page, run.first * sizeof(shared::PolygonRecord),
		                     run.padded * sizeof(shared::PolygonRecord));
	else // a shader without records does not look at this binding
		writer.storageBuffer(shared::kBindRecords, workspace_->codes.handle(), 4 * run.offset, 4 * run.count);
	writer.write(blocks_.device(), set);

	sheet.pipeline->bind(commands, set);
	sheet.pipeline->push(commands, shared::ClassifyPush{static_cast<std::uint32_t>(run.count), run.padded});
	vkCmdDispatch(commands, (run.padded + shared::kClassifyGroupSize - 1) / shared::kClassifyGroupSize, 1, 1);
}

} // namespace vp::classify
