#pragma once

#include "classify/gpu_pipelines.h"
#include "classify/gpu_records.h"
#include "classify/gpu_upload.h"
#include "gpu/shader.h"
#include "grid/block.h"
#include "grid/field_choice.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace vp::classify
{

struct ClassifyWorkspace; // gpu_workspace.h

// Limits that tests tighten; 0 leaves the device's own.
struct GpuBlocksOptions
{
	bool doubles = true; // uses doubles if the device has exact ones
	std::uint32_t page_records = RecordPool::kPageRecords;
	std::uint64_t max_elements = 0; // largest number of elements of an array
	std::uint64_t max_bytes = 0;
};

// The shown array of every block.
struct GpuField
{
	std::optional<grid::FieldChoice> choice;
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
	const std::vector<std::string>& warnings() const
	{
		return warnings_;
	}                          // for the user: what was left to the CPU, and why
	std::size_t bytes() const; // device memory in bytes, record pages included

	// The values of an array, and the pipelines for them, each run once since a driver may compile a shader on its
	// first use. The arrays asked for last are kept.
	using Fields = std::vector<std::shared_ptr<const GpuField>>;
	Result<Fields> fields(std::span<const std::optional<grid::FieldChoice>> choices);
	void forgetFields(); // the blocks' values have changed
	const std::shared_ptr<RecordPool>& recordPool() const { return records_; }

	// For the classifier.
	const GpuBlock& block(std::size_t block) const { return *blocks_[block]; }
	bool usesDoubles() const { return doubles_; }
	std::shared_ptr<const gpu::Pipeline> pipeline(const GpuBlock& block, const GpuValues& values) const;
	// Any that stays: the descriptor sets of all are alike. Some pipeline has been asked for.
	const gpu::Pipeline& lastingPipeline() const;
	SurfacePipelines& surfacePipelines() { return surface_pipelines_; }
	gpu::ShaderArray::Place cases() const { return cases_.place(); }
	gpu::ShaderArray::Place noValues() const { return no_values_.place(); } // stands in where there are no values
	std::unique_ptr<ClassifyWorkspace> borrowWorkspace();
	void giveBack(std::unique_ptr<ClassifyWorkspace> workspace);

private:
	GpuBlocks(gpu::Device& device, const grid::BlockSet& set, const GpuBlocksOptions& options);

	Status uploadBlocks();
	Result<std::shared_ptr<const GpuField>> uploadField(const std::optional<grid::FieldChoice>& choice);
	Status makePipeline(const PipelineKinds& kinds);

	gpu::Device& device_;
	const grid::BlockSet& set_;
	GpuLimits limits_;
	bool doubles_;
	std::vector<std::unique_ptr<GpuBlock>> blocks_; // null where left to the CPU
	std::vector<std::string> warnings_;
	gpu::ShaderArray cases_;
	gpu::ShaderArray no_values_;
	std::shared_ptr<RecordPool> records_;
	SurfacePipelines surface_pipelines_;

	mutable std::mutex mutex_; // guards the members below
	std::map<PipelineKinds, std::shared_ptr<const gpu::Pipeline>> pipelines_;
	Fields fields_;
	std::vector<std::unique_ptr<ClassifyWorkspace>> workspaces_;
};

} // namespace vp::classify
