#pragma once

#include "gpu/buffer.h"
#include "gpu/shader.h"
#include "grid/block.h"
#include "slice/field_choice.h"
#include "slice/gpu_records.h"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::slice
{

struct ClassifyWorkspace; // gpu_workspace.h

// Limits that tests tighten; 0 leaves the device's own.
struct GpuBlocksOptions
{
	bool doubles = true; // where the device has them
	std::uint32_t page_records = RecordPool::kPageRecords;
	std::uint64_t max_texels = 0;
	std::uint64_t max_bytes = 0;
};

// How a block lies in device memory; see shared/classify_types.h for the formats.
struct GpuBlock
{
	std::uint32_t cells_kind = 0;  // kCellsAxes …
	std::uint32_t points_kind = 0; // kPointsFloat …
	gpu::Buffer points;
	gpu::TexelView point_texels;
	gpu::Buffer cells;
	gpu::TexelView cell_texels;
	// Of the points; for fixed-point numbers the centre and unit they count from.
	Box bounds;
	Vec3 centre{0.0};
	Vec3 unit{1.0};
};

// The shown array of a block in the block's own numbering, R32F, `components` texels a point or cell.
struct GpuValues
{
	std::uint32_t kind = 0; // kValuesNone …
	std::uint32_t components = 0;
	gpu::Buffer buffer;
	gpu::TexelView texels;
};

struct GpuField
{
	std::optional<FieldChoice> choice;
	std::vector<GpuValues> blocks;
};

// A block set in device memory, with the pipelines that classify it. Thread safe; outlives the slices made from it, as
// the device and the block set outlive it.
class GpuBlocks
{
public:
	// Uploads what fits. Ask for the first field at once: that makes the pipelines.
	static Result<std::unique_ptr<GpuBlocks>> create(gpu::Device& device, const grid::BlockSet& blocks,
	                                                 const GpuBlocksOptions& options = {});
	~GpuBlocks();
	GpuBlocks(const GpuBlocks&) = delete;
	GpuBlocks& operator=(const GpuBlocks&) = delete;

	gpu::Device& device() const { return device_; }
	const grid::BlockSet& blocks() const { return set_; }
	// A block past a limit of the device is left to the CPU.
	bool holds(std::size_t block) const { return blocks_[block] != nullptr; }
	std::size_t heldCount() const;
	const std::vector<std::string>& words() const { return words_; } // for the user: what was left to the CPU, and why
	std::size_t bytes() const;                                       // of device memory that blocks and values take

	// The values of an array, and the pipelines for them, each run once since a driver may compile a shader on its
	// first use. The last array asked for is kept.
	Result<std::shared_ptr<const GpuField>> field(const std::optional<FieldChoice>& choice);
	const std::shared_ptr<RecordPool>& recordPool() const { return records_; }

	// For the classifier.
	const GpuBlock& block(std::size_t block) const { return *blocks_[block]; }
	bool usesDoubles() const { return doubles_; }
	const gpu::Pipeline& pipeline(const GpuBlock& block, const GpuValues& values);
	VkBufferView caseTexels() const { return case_texels_.handle(); }
	VkBufferView noValueTexels() const { return no_value_texels_.handle(); } // stands in where there are no values
	std::unique_ptr<ClassifyWorkspace> borrowWorkspace();
	void giveBack(std::unique_ptr<ClassifyWorkspace> workspace);

private:
	GpuBlocks(gpu::Device& device, const grid::BlockSet& set, const GpuBlocksOptions& options);

	Status uploadBlocks();
	Status makePipeline(const GpuBlock& block, const GpuValues& values);
	Status warmUp(const gpu::Pipeline& pipeline);
	// Whether an array of texels fits the device's limits; if not, why.
	bool fits(std::uint64_t texels, std::uint64_t bytes, std::string& why) const;
	Result<std::unique_ptr<GpuBlock>> uploadBlock(const grid::Block& block);
	Result<GpuValues> uploadValues(const grid::Block& block, const FieldChoice& choice);

	gpu::Device& device_;
	const grid::BlockSet& set_;
	GpuBlocksOptions options_;
	bool doubles_;
	std::vector<std::unique_ptr<GpuBlock>> blocks_; // null where left to the CPU
	std::vector<std::string> words_;
	gpu::Buffer cases_;
	gpu::TexelView case_texels_;
	gpu::Buffer no_values_;
	gpu::TexelView no_value_texels_;
	std::shared_ptr<RecordPool> records_;

	mutable std::mutex mutex_;                                        // of what follows
	std::map<std::array<std::uint32_t, 3>, gpu::Pipeline> pipelines_; // by the kinds of cells, points and values
	std::shared_ptr<const GpuField> field_;
	std::vector<std::unique_ptr<ClassifyWorkspace>> workspaces_;
};

} // namespace vp::slice
