#include "classify/gpu_blocks.h"

#include "classify/gpu_workspace.h"
#include "gpu/commands.h"
#include "shared/classify_types.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::classify
{

GpuBlocks::GpuBlocks(gpu::Device& device, const grid::BlockSet& set, const GpuBlocksOptions& options)
    : device_(device), set_(set), limits_{options.max_elements, options.max_bytes},
      doubles_(options.doubles && device.hasExactDoubles()), records_(RecordPool::create(device, options.page_records)),
      surface_pipelines_(device)
{
	// A buffer may be a little larger than requested.
	constexpr std::uint64_t kSlack = 256;
	if (!limits_.elements)
		limits_.elements = gpu::ShaderArray::maxElements(device) - kSlack;
	// Shaders index texels with an int.
	limits_.elements = std::min<std::uint64_t>(limits_.elements, 0x7FFFFFFFu);
	if (!limits_.bytes)
		limits_.bytes = device.maxBufferSize() - kSlack;
}

GpuBlocks::~GpuBlocks() = default;

Result<std::unique_ptr<GpuBlocks>> GpuBlocks::create(gpu::Device& device, const grid::BlockSet& blocks,
                                                     const GpuBlocksOptions& options)
{
	std::unique_ptr<GpuBlocks> made(new GpuBlocks(device, blocks, options));
	Result<gpu::ShaderArray> cases = uploadCaseTables(device);
	if (!cases)
		return cases.error();
	made->cases_ = std::move(*cases);
	Result<gpu::ShaderArray> no_values = uploadNoValues(device);
	if (!no_values)
		return no_values.error();
	made->no_values_ = std::move(*no_values);
	if (Status done = made->uploadBlocks(); !done)
		return done.error();
	return made;
}

Status GpuBlocks::uploadBlocks()
{
	for (const grid::Block& block : set_.blocks)
	{
		std::string why = whyNotOnDevice(device_, limits_, block);
		std::unique_ptr<GpuBlock> on_device;
		if (why.empty())
		{
			Result<std::unique_ptr<GpuBlock>> uploaded = uploadBlock(device_, block);
			if (uploaded)
				on_device = std::move(*uploaded);
			else if (uploaded.error().kind == ErrorKind::device)
				return uploaded.error(); // lost
			else
				why = uploaded.error().message; // out of memory
		}
		if (!on_device)
			warnings_.push_back(fmt::format("block {} is classified by the CPU: {}", block.name, why));
		blocks_.push_back(std::move(on_device));
	}
	return Nothing{};
}

std::size_t GpuBlocks::heldCount() const
{
	return static_cast<std::size_t>(
	    std::count_if(blocks_.begin(), blocks_.end(), [](const auto& block) { return block != nullptr; }));
}

std::size_t GpuBlocks::bytes() const
{
	std::size_t sum = records_->bytes();
	for (const auto& block : blocks_)
		if (block)
			sum += block->points.buffer().size() + block->cells.buffer().size();
	const std::lock_guard lock(mutex_);
	for (const auto& field : fields_)
		for (const GpuValues& values : field->blocks)
			sum += values.array.buffer().size();
	return sum;
}

Result<GpuBlocks::Fields> GpuBlocks::fields(std::span<const std::optional<grid::FieldChoice>> choices)
{
	const std::lock_guard lock(mutex_);
	// Unused arrays are dropped first, unless a slice still needs them, since old and new may not fit together.
	std::erase_if(fields_,
	              [&](const auto& field) { return std::ranges::find(choices, field->choice) == choices.end(); });
	Fields asked;
	for (const std::optional<grid::FieldChoice>& choice : choices)
	{
		auto known = std::ranges::find(fields_, choice, [](const auto& field) { return field->choice; });
		if (known == fields_.end())
		{
			Result<std::shared_ptr<const GpuField>> uploaded = uploadField(choice);
			if (!uploaded)
				return uploaded.error();
			known = fields_.insert(fields_.end(), std::move(*uploaded));
		}
		asked.push_back(*known);
	}
	return asked;
}

void GpuBlocks::forgetFields()
{
	const std::lock_guard lock(mutex_);
	fields_.clear();
}

Result<std::shared_ptr<const GpuField>> GpuBlocks::uploadField(const std::optional<grid::FieldChoice>& choice)
{
	auto made = std::make_shared<GpuField>();
	made->choice = choice;
	made->blocks.resize(blocks_.size());
	for (std::size_t b = 0; b < blocks_.size(); ++b)
	{
		if (!blocks_[b])
			continue;
		if (choice)
		{
			Result<GpuValues> values = uploadValues(device_, set_.blocks[b], *choice);
			if (!values)
				return values.error();
			made->blocks[b] = std::move(*values);
		}
		if (Status done = makePipeline({blocks_[b]->cells_kind, blocks_[b]->points_kind, made->blocks[b].kind}); !done)
			return done.error();
	}
	return std::shared_ptr<const GpuField>(std::move(made));
}

std::shared_ptr<const gpu::Pipeline> GpuBlocks::pipeline(const GpuBlock& block, const GpuValues& values) const
{
	const std::lock_guard lock(mutex_);
	return pipelines_.at({block.cells_kind, block.points_kind, values.kind});
}

const gpu::Pipeline& GpuBlocks::lastingPipeline() const
{
	const std::lock_guard lock(mutex_);
	return pipelines_.empty() ? surface_pipelines_.first() : *pipelines_.begin()->second;
}

Status GpuBlocks::makePipeline(const PipelineKinds& kinds)
{
	if (pipelines_.count(kinds))
		return Nothing{};
	gpu::ComputePipelineInfo info = classifyPipelineInfo(device_, kinds);
	const bool storage = gpu::ShaderArray::usesStorage(device_);
	if (doubles_)
		info.shader = storage ? "classify_double.comp.storage" : "classify_double.comp";
	else
		info.shader = storage ? "classify_single.comp.storage" : "classify_single.comp";
	Result<gpu::Pipeline> made = gpu::Pipeline::create(device_, info, "classify");
	if (!made)
		return made.error();
	if (Status warm = warmUp(device_, *made, kinds, cases()); !warm)
		return warm;
	pipelines_.emplace(kinds, std::make_shared<const gpu::Pipeline>(std::move(*made)));
	return Nothing{};
}

std::unique_ptr<ClassifyWorkspace> GpuBlocks::borrowWorkspace()
{
	const std::lock_guard lock(mutex_);
	if (workspaces_.empty())
		return std::make_unique<ClassifyWorkspace>(device_);
	std::unique_ptr<ClassifyWorkspace> workspace = std::move(workspaces_.back());
	workspaces_.pop_back();
	return workspace;
}

void GpuBlocks::giveBack(std::unique_ptr<ClassifyWorkspace> workspace)
{
	const std::lock_guard lock(mutex_);
	workspaces_.push_back(std::move(workspace));
}

} // namespace vp::classify
