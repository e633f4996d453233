#pragma once

#include "classify/gpu_blocks.h"
#include "classify/gpu_sheet_in_block.h"
#include "find/generations.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::classify
{

/// Classifies on the device: one submission serves a generation of all sheets in all blocks, and codes come back for
/// the traversal. For planes (gpu_planes.h) and curved surfaces (gpu_surfaces.h). One per cut; used by one thread.
///
/// The codes are those of the CPU classifier, but for cells whose signs or polygon are not certain in the device's
/// arithmetic: they come back as kCodeWalk with an empty record, so that the traversal decides them in double.
class GpuClassifier
{
public:
	/// Classifies the fronts of what has no pipeline, while the device works.
	using OnCpu = std::function<Status(std::span<const find::Front>)>;

	/// sheets: in the order in which they are traversed. Sections "classify" go to the timeline, which may be null.
	static Result<std::unique_ptr<GpuClassifier>> create(GpuBlocks& blocks, std::vector<GpuSheetInBlock> sheets,
	                                                     OnCpu on_cpu, Timeline* timeline);
	~GpuClassifier(); // waits, and adds the times to the timeline
	GpuClassifier(const GpuClassifier&) = delete;
	GpuClassifier& operator=(const GpuClassifier&) = delete;

	Status classify(std::span<const find::Front> fronts);

private:
	// A dispatch: some cells of a front, whose records, where there are any, go to one page.
	struct Run
	{
		const find::Front* front;
		std::size_t begin; // index of its first cell in the front
		std::size_t count;
		std::size_t offset;                                       // offset of its cells and codes in the buffers
		VkBuffer page = nullptr;                                  // null: no records
		std::uint32_t first = 0;                                  // first record
		std::uint32_t padded = static_cast<std::uint32_t>(count); // number of records, including empty ones
	};

	GpuClassifier(GpuBlocks& blocks, std::vector<GpuSheetInBlock> sheets, OnCpu on_cpu, Timeline* timeline);

	Status prepare();
	Status planRuns(std::span<const find::Front> fronts);
	Status addRuns(const find::Front& front, std::size_t& offset);
	Status placeRecords(const find::Front& front, std::size_t begin, Run& run);
	Status submit();
	Status record(VkCommandBuffer commands);
	void recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set);

	GpuBlocks& blocks_;
	std::vector<GpuSheetInBlock> sheets_;
	OnCpu on_cpu_;
	Timeline* timeline_;
	std::unique_ptr<ClassifyWorkspace> workspace_;
	std::vector<std::uint32_t> cells_done_; // per sheet in a block
	std::size_t told_stride_;               // bytes from one surface's parameters to the next one's
	std::size_t code_alignment_;            // alignment of a run's cells and codes, in codes
	std::uint32_t record_alignment_;        // alignment of a run's records
	std::vector<Run> runs_;                 // runs of the generation
	std::vector<find::Front> cpu_fronts_;   // the generation's fronts that the CPU classifies
};

} // namespace vp::classify
