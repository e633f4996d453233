#include "classify/gpu_surface_classifier.h"

#include "base/timeline.h"
#include "classify/gpu_workspace.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace vp::classify
{

namespace
{

// Of a dispatch: 2^14 groups, where a device takes 65 535 at least.
constexpr std::size_t kMaxRun = std::size_t(shared::kClassifyGroupSize) << 14;

} // namespace

GpuSurfaceClassifier::GpuSurfaceClassifier(GpuBlocks& blocks, std::vector<Lane> lanes, OnCpu on_cpu, Timeline* timeline)
    : blocks_(blocks), lanes_(std::move(lanes)), on_cpu_(std::move(on_cpu)), timeline_(timeline),
      pipelines_(lanes_.size())
{
	const VkPhysicalDeviceLimits& limits = blocks.device().limits();
	lane_stride_ = roundUp(sizeof(shared::SurfaceLane), limits.minUniformBufferOffsetAlignment);
	word_alignment_ = std::max<std::size_t>(limits.minStorageBufferOffsetAlignment, 4) / 4;
}

Result<std::unique_ptr<GpuSurfaceClassifier>> GpuSurfaceClassifier::create(GpuBlocks& blocks,

                                                                           std::vector<Lane> lanes, OnCpu on_cpu,
                                                                           Timeline* timeline)
{
	std::unique_ptr<GpuSurfaceClassifier> made(
	    new GpuSurfaceClassifier(blocks, std::move(lanes), std::move(on_cpu), timeline));
	if (Status prepared = made->prepare(); !prepared)
		return prepared.error();
	return made;
}

GpuSurfaceClassifier::~GpuSurfaceClassifier()
{
	if (!workspace_)
		return;
	if (workspace_->commands.handle() && workspace_->commands.wait() && timeline_)
		workspace_->timers.collect(*timeline_);
	blocks_.giveBack(std::move(workspace_));
}

Status GpuSurfaceClassifier::makePipelines()
{
	for (std::size_t l = 0; l < lanes_.size(); ++l)
	{
		const Lane& lane = lanes_[l];
		if (!lane.surface || !blocks_.holds(lane.block))
			continue;
		const GpuBlock& block = blocks_.block(lane.block);
		const auto* placed = std::get_if<surface::PlacedExpression>(&*lane.surface);
		auto pipeline = blocks_.surfacePipelines().get(block.cells_kind, block.points_kind,
		                                               placed ? &placed->expression() : nullptr, blocks_.caseTexels());
		if (!pipeline)
			return pipeline.error();
		pipelines_[l] = std::move(*pipeline);
	}
	return Nothing{};
}

Status GpuSurfaceClassifier::prepare()
{
	if (Status made = makePipelines(); !made)
		return made;
	if (std::ranges::none_of(pipelines_, [](const auto& pipeline) { return pipeline != nullptr; }))
		return Nothing{};
	std::size_t axis_texels = 1;
	for (std::size_t l = 0; l < lanes_.size(); ++l)
		if (pipelines_[l])
			axis_texels += axisTexels(blocks_.blocks().blocks[lanes_[l].block].grid);
	if (Status done = reserve(axis_texels); !done)
		return done;

	const std::span<AxisTexel> axes(workspace_->axes.mappedAs<AxisTexel>(), axis_texels);
	std::size_t axis_start = 0;
	for (std::size_t l = 0; l < lanes_.size(); ++l)
	{
		if (!pipelines_[l])
			continue;
		const Lane& lane = lanes_[l];
		const grid::Block& block = blocks_.blocks().blocks[lane.block];
		const std::size_t texels = axisTexels(block.grid);
		const shared::SurfaceLane described = describeSurfaceLane(block, blocks_.block(lane.block), *lane.surface,
		                                                          axis_start, axes.subspan(axis_start, texels));
		std::memcpy(workspace_->lanes.mappedAs<std::byte>() + l * lane_stride_, &described, sizeof(described));
		axis_start += texels;
	}
	return Nothing{};
}

Status GpuSurfaceClassifier::reserve(std::size_t axis_texels)
{
	workspace_ = blocks_.borrowWorkspace();
	gpu::Device& device = blocks_.device();
	if (Status done = workspace_->prepare(device, blocks_.surfacePipelines().first()); !done)
		return done;
	if (Status done = workspace_->reserveLanes(device, lanes_.size() * lane_stride_); !done)
		return done;
	return workspace_->reserveAxes(device, axis_texels);
}

Status GpuSurfaceClassifier::classify(std::span<const find::FrontSlice> fronts)
{
	if (Status planned = planRuns(fronts); !planned)
		return planned;
	if (!runs_.empty())
		if (Status submitted = submit(); !submitted)
			return submitted;
	// While the device works.
	if (!cpu_fronts_.empty())
		if (Status done = on_cpu_(cpu_fronts_); !done)
			return done;
	if (runs_.empty())
		return Nothing{};

	return workspace_->takeWords(runs_);
}

Status GpuSurfaceClassifier::planRuns(std::span<const find::FrontSlice> fronts)
{
	runs_.clear();
	cpu_fronts_.clear();
	std::size_t offset = 0;
	for (const find::FrontSlice& front : fronts)
	{
		if (!pipelines_[front.lane])
		{
			cpu_fronts_.push_back(front);
			continue;
		}
		for (std::size_t begin = 0; begin < front.cells.size(); begin += kMaxRun)
		{
			const std::size_t count = std::min(kMaxRun, front.cells.size() - begin);
			runs_.push_back({&front, begin, count, offset});
			offset += roundUp(count, word_alignment_);
		}
	}
	return runs_.empty() ? Status(Nothing{}) : workspace_->reserveFront(blocks_.device(), offset);
}

Status GpuSurfaceClassifier::submit()
{
	auto* cells = workspace_->front.mappedAs<CellId>();
	for (const Run& run : runs_)
		std::memcpy(cells + run.offset, run.front->cells.data() + run.begin, run.count * sizeof(CellId));
	Result<VkCommandBuffer> commands = workspace_->commands.begin();
	if (!commands)
		return commands.error();
	{
		std::optional<gpu::TimedPass> timed; // labels the pass as well
		std::optional<gpu::Label> label;
		if (timeline_)
			timed.emplace(workspace_->timers, *commands, "classify");
		else
			label.emplace(blocks_.device(), *commands, "classify");
		for (std::size_t i = 0; i < runs_.size(); ++i)
		{
			Result<VkDescriptorSet> set = workspace_->sets.get(i);
			if (!set)
				return set.error();
			recordRun(*commands, runs_[i], *set);
		}
		// Words to the host.
		gpu::memoryBarrier(*commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
		                   VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
	}
	Result<std::uint64_t> submitted = workspace_->commands.submit();
	return submitted ? Status(Nothing{}) : Status(submitted.error());
}

void GpuSurfaceClassifier::recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set)
{
	const GpuBlock& block = blocks_.block(lanes_[run.front->lane].block);
	const auto orCases = [&](const GpuTexels& texels) { return texels ? texels.view.handle() : blocks_.caseTexels(); };

	// Descriptors cover what the run touches and no more, so runs of a generation need no barrier between them. Values
	// and records are there for the classifier of planes.
	gpu::DescriptorWriter writer;
	writer.texels(shared::kBindPoints, orCases(block.points))
	    .texels(shared::kBindCells, orCases(block.cells))
	    .texels(shared::kBindCases, blocks_.caseTexels())
	    .texels(shared::kBindValues, blocks_.noValueTexels())
	    .texels(shared::kBindAxes, workspace_->axis_texels.handle())
	    .storageBuffer(shared::kBindFront, workspace_->front.handle(), 4 * run.offset, 4 * run.count)
	    .storageBuffer(shared::kBindWords, workspace_->words.handle(), 4 * run.offset, 4 * run.count)
	    .storageBuffer(shared::kBindRecords, workspace_->words.handle(), 4 * run.offset, 4 * run.count)
	    .uniformBuffer(shared::kBindLane, workspace_->lanes.handle(), run.front->lane * lane_stride_,
	                   sizeof(shared::SurfaceLane))
	    .write(blocks_.device(), set);

	const auto count = static_cast<std::uint32_t>(run.count);
	const gpu::Pipeline& pipeline = *pipelines_[run.front->lane];
	pipeline.bind(commands, set);
	pipeline.push(commands, shared::ClassifyPush{count, count});
	vkCmdDispatch(commands, (count + shared::kClassifyGroupSize - 1) / shared::kClassifyGroupSize, 1, 1);
}

} // namespace vp::classify
