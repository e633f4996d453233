#include "slice/gpu_blocks.h"

#include "cases/case_table.h"
#include "gpu/commands.h"
#include "gpu/upload.h"
#include "slice/gpu_points.h"
#include "slice/gpu_workspace.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>

namespace vp::slice
{

GpuBlocks::GpuBlocks(gpu::Device& device, const grid::BlockSet& set, const GpuBlocksOptions& options)
    : device_(device), set_(set), options_(options), doubles_(options.doubles && device.features().shaderFloat64),
      records_(RecordPool::create(device, options.page_records))
{
	// A texel buffer may come a little larger than asked for.
	constexpr std::uint64_t kSlack = 256;
	if (!options_.max_texels)
		options_.max_texels = device.limits().maxTexelBufferElements - kSlack;
	// Shaders index texels with an int.
	options_.max_texels = std::min<std::uint64_t>(options_.max_texels, 0x7FFFFFFFu);
	if (!options_.max_bytes)
		options_.max_bytes = device.maxBufferSize();
}

GpuBlocks::~GpuBlocks() = default;

Result<std::unique_ptr<GpuBlocks>> GpuBlocks::create(gpu::Device& device, const grid::BlockSet& blocks,
                                                     const GpuBlocksOptions& options)
{
	std::unique_ptr<GpuBlocks> made(new GpuBlocks(device, blocks, options));
	const std::vector<std::uint32_t> cases = cases::packedCaseTables();
	using Case = std::array<std::uint32_t, 4>;
	if (Status done = makeTexels<Case>(
	        device, cases.size() / 4, VK_FORMAT_R32G32B32A32_UINT, "case tables", made->cases_, made->case_texels_,
	        [&](std::size_t i, Case& texel) { std::memcpy(texel.data(), &cases[4 * i], sizeof(Case)); });
	    !done)
		return done.error();
	if (Status done = makeTexels<float>(device, 1, VK_FORMAT_R32_SFLOAT, "no values", made->no_values_,
	                                    made->no_value_texels_, [](std::size_t, float& texel) { texel = 0.0f; });
	    !done)
		return done.error();
	if (Status done = made->uploadBlocks(); !done)
		return done.error();
	return made;
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
			sum += block->points.size() + block->cells.size();
	const std::lock_guard lock(mutex_);
	if (field_)
		for (const GpuValues& values : field_->blocks)
			sum += values.buffer.size();
	return sum;
}

bool GpuBlocks::fits(std::uint64_t texels, std::uint64_t bytes, std::string& why) const
{
	if (texels > options_.max_texels)
		why = fmt::format("{} texels where the device takes {}", texels, options_.max_texels);
	else if (bytes > options_.max_bytes)
		why = fmt::format("{} bytes where a buffer of the device holds {}", bytes, options_.max_bytes);
	else if (bytes > device_.memoryLeft())
		why = fmt::format("{} bytes where the device has {} left", bytes, device_.memoryLeft());
	return why.empty();
}

Status GpuBlocks::uploadBlocks()
{
	for (const grid::Block& block : set_.blocks)
	{
		std::string why;
		std::uint64_t most_texels = 0;
		std::uint64_t most_bytes = 0;
		const auto count = [&](std::uint64_t texels, std::uint64_t texel_bytes)
		{
			most_texels = std::max(most_texels, texels);
			most_bytes = std::max(most_bytes, texels * texel_bytes);
		};
		if (const grid::Points* points = coordinatesOf(block.grid))
			count(points->size(), 16);
		if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
			count(grid->records().size() / 4, 16);
		if (fits(most_texels, most_bytes, why))
		{
			Result<std::unique_ptr<GpuBlock>> uploaded = uploadBlock(block);
			if (uploaded)
			{
				blocks_.push_back(std::move(*uploaded));
				continue;
			}
			// Out of memory leaves this block to the CPU; a lost device ends it all.
			if (uploaded.error().code == ExitCode::no_device)
				return uploaded.error();
			why = uploaded.error().message;
		}
		words_.push_back(fmt::format("block {} is classified by the CPU: {}", block.name, why));
		blocks_.push_back(nullptr);
	}
	return Nothing{};
}

Result<std::unique_ptr<GpuBlock>> GpuBlocks::uploadBlock(const grid::Block& block)
{
	using Texel = std::array<std::uint32_t, 4>;
	auto made = std::make_unique<GpuBlock>();
	made->cells_kind = std::visit([](const auto& grid) { return cellsKind(grid); }, block.grid);
	made->bounds = block.bounds;
	if (const grid::Points* points = coordinatesOf(block.grid))
	{
		// Not the block's bounds, which may leave out points of no cell.
		made->bounds = boundsOf(*points);
		made->points_kind = points->isDouble() ? shared::kPointsFixed : shared::kPointsFloat;
		const FixedPoints fixed(made->bounds.empty() ? Box{Vec3(0.0), Vec3(0.0)} : made->bounds);
		made->centre = fixed.centre();
		made->unit = fixed.unit();
		const auto write = [&](std::size_t i, Texel& texel)
		{
			const Vec3 point = (*points)[i];
			if (points->isDouble())
				texel = fixed.pack(point);
			else
				for (int axis = 0; axis < 3; ++axis)
					texel[axis] = std::bit_cast<std::uint32_t>(static_cast<float>(point[axis]));
		};
		if (Status done = makeTexels<Texel>(device_, points->size(), VK_FORMAT_R32G32B32A32_UINT,
		                                    block.name + " points", made->points, made->point_texels, write);
		    !done)
			return done.error();
	}
	if (const auto* grid = std::get_if<grid::UnstructuredGrid>(&block.grid))
	{
		const std::vector<std::uint32_t>& ids = grid->records();
		if (Status done = makeTexels<Texel>(device_, ids.size() / 4, VK_FORMAT_R32G32B32A32_UINT, block.name + " cells",
		                                    made->cells, made->cell_texels,
		                                    [&](std::size_t i, Texel& texel)
		                                    { std::memcpy(texel.data(), &ids[4 * i], sizeof(Texel)); });
		    !done)
			return done.error();
	}
	return made;
}

Result<std::shared_ptr<const GpuField>> GpuBlocks::field(const std::optional<FieldChoice>& choice)
{
	const std::lock_guard lock(mutex_);
	const auto same = [](const std::optional<FieldChoice>& a, const std::optional<FieldChoice>& b)
	{
		return a.has_value() == b.has_value() &&
		       (!a || (a->name == b->name && a->association == b->association && a->component == b->component));
	};
	if (field_ && same(field_->choice, choice))
		return field_;
	// The old one goes first, unless a slice still uses it: both may not fit.
	field_.reset();
	auto made = std::make_shared<GpuField>();
	made->choice = choice;
	made->blocks.resize(blocks_.size());
	for (std::size_t b = 0; b < blocks_.size(); ++b)
	{
		if (!blocks_[b])
			continue;
		if (choice)
		{
			Result<GpuValues> values = uploadValues(set_.blocks[b], *choice);
			if (!values)
				return values.error();
			made->blocks[b] = std::move(*values);
		}
		if (Status piped = makePipeline(*blocks_[b], made->blocks[b]); !piped)
			return piped.error();
	}
	field_ = made;
	return field_;
}

Result<GpuValues> GpuBlocks::uploadValues(const grid::Block& block, const FieldChoice& choice)
{
	GpuValues made;
	const grid::Field* field = choice.in(block);
	if (!field)
		return made;
	const bool on_points = choice.association == grid::Association::point;
	const bool tuple = choice.component == grid::kMagnitude;
	if (on_points)
		made.kind = tuple ? shared::kValuesPointTuple : shared::kValuesPoint;
	else
		made.kind = tuple ? shared::kValuesCellTuple : shared::kValuesCell;
	made.components = tuple ? static_cast<std::uint32_t>(field->components) : 1;
	const int first = tuple ? 0 : choice.component;
	const auto upload = [&](const auto& grid) -> Status
	{
		const std::size_t tuples = on_points ? grid.pointCount() : grid.cellCount();
		std::string why;
		if (!fits(tuples * made.components, tuples * made.components * 4, why))
			return Error{ExitCode::output,
			             fmt::format("array {} of block {} does not fit the device: {}; use --classify cpu",
			                         field->name, block.name, why)};
		return makeTexels<float>(
		    device_, tuples * made.components, VK_FORMAT_R32_SFLOAT, block.name + " values", made.buffer, made.texels,
		    [&](std::size_t i, float& texel)
		    {
			    const std::size_t number = i / made.components;
			    const std::size_t source = on_points ? grid.sourcePoint(static_cast<PointId>(number))
			                                         : grid.sourceCell(static_cast<CellId>(number));
			    texel = shownValue(field->value(source, first + static_cast<int>(i - number * made.components)));
		    });
	};
	if (Status done = std::visit(upload, block.grid); !done)
		return done.error();
	return made;
}

const gpu::Pipeline& GpuBlocks::pipeline(const GpuBlock& block, const GpuValues& values)
{
	const std::lock_guard lock(mutex_);
	return pipelines_.at({block.cells_kind, block.points_kind, values.kind});
}

Status GpuBlocks::makePipeline(const GpuBlock& block, const GpuValues& values)
{
	const std::array kinds{block.cells_kind, block.points_kind, values.kind};
	if (pipelines_.count(kinds))
		return Nothing{};
	gpu::ComputePipelineInfo info;
	info.shader = doubles_ ? "classify_double.comp" : "classify_single.comp";
	for (const std::uint32_t binding :
	     {shared::kBindPoints, shared::kBindCells, shared::kBindCases, shared::kBindValues, shared::kBindAxes})
		info.bindings.push_back({binding, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER});
	for (const std::uint32_t binding : {shared::kBindFront, shared::kBindWords, shared::kBindRecords})
		info.bindings.push_back({binding, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER});
	info.bindings.push_back({shared::kBindLane, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER});
	info.push_bytes = sizeof(shared::ClassifyPush);
	info.constants = {
	    {shared::kConstantCells, kinds[0]}, {shared::kConstantPoints, kinds[1]}, {shared::kConstantValues, kinds[2]}};
	Result<gpu::Pipeline> made = gpu::Pipeline::create(device_, info, "classify");
	if (!made)
		return made.error();
	if (Status warm = warmUp(*made); !warm)
		return warm;
	pipelines_.emplace(kinds, std::move(*made));
	return Nothing{};
}

Status GpuBlocks::warmUp(const gpu::Pipeline& pipeline)
{
	gpu::DescriptorSets sets(device_, pipeline, "warm-up");
	Result<VkDescriptorSet> set = sets.get(0);
	if (!set)
		return set.error();
	Result<gpu::Buffer> room =
	    gpu::Buffer::create(device_, 1024, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
	                        gpu::Memory::device, "warm-up");
	if (!room)
		return room.error();
	static_assert(sizeof(shared::ClassifyLane) <= 1024);
	gpu::DescriptorWriter writer;
	for (const std::uint32_t binding : {shared::kBindPoints, shared::kBindCells, shared::kBindCases, shared::kBindAxes})
		writer.texels(binding, case_texels_.handle());
	writer.texels(shared::kBindValues, no_value_texels_.handle());
	for (const std::uint32_t binding : {shared::kBindFront, shared::kBindWords, shared::kBindRecords})
		writer.storageBuffer(binding, room->handle());
	writer.uniformBuffer(shared::kBindLane, room->handle());
	writer.write(device_, *set);
	return gpu::runOnce(device_, "warm-up",
	                    [&](VkCommandBuffer commands)
	                    {
		                    // No cells: the shader is compiled, and returns at once.
		                    pipeline.bind(commands, *set);
		                    pipeline.push(commands, shared::ClassifyPush{0, 0});
		                    vkCmdDispatch(commands, 1, 1, 1);
	                    });
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

} // namespace vp::slice
