#pragma once

#include "classify/cpu_classifier.h"
#include "classify/gpu_blocks.h"
#include "classify/gpu_lane.h"
#include "classify/gpu_records.h"
#include "find/generations.h"
#include "grid/field_choice.h"
#include "probe/sheet.h"
#include "shared/classify_types.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::classify
{

// Classifies on the device: one submission serves a generation of all lanes. The shader decides each cell, looks its
// case up and writes its polygon into the sheet's records; the words come back for the traversal. Lanes in blocks that
// the device does not hold are classified here, and emit nothing. One per slice; used by one thread.
//
// The words are those of the CPU classifier, but for cells whose signs or polygon are not certain in the device's
// arithmetic: they come back as kCodeWalk with an empty record, so that the traversal decides them in double.
class GpuClassifier
{
public:
	// `fields` one a sheet, `lanes` in the order in which they are traversed. Sections "classify" go to the timeline,
	// which may be null.
	static Result<std::unique_ptr<GpuClassifier>> create(GpuBlocks& blocks, std::span<const probe::Sheet> sheets,
	                                                     std::span<const std::optional<grid::FieldChoice>> fields,
	                                                     std::vector<GpuLane> lanes, Timeline* timeline);
	~GpuClassifier();
	GpuClassifier(const GpuClassifier&) = delete;
	GpuClassifier& operator=(const GpuClassifier&) = delete;

	Status classify(std::span<const find::FrontSlice> fronts);

	// The records of each sheet, after the last generation; adds the times to the timeline.
	std::vector<std::shared_ptr<SheetRecords>> finish();

private:
	// A dispatch: some cells of a front whose records go to one page.
	struct Run
	{
		const find::FrontSlice* front;
		std::size_t begin; // of its cells in the front
		std::size_t count;
		std::size_t offset; // of its cells and words in the buffers
		VkBuffer page;
		std::uint32_t first; // record
		std::uint32_t padded;
	};

	GpuClassifier(GpuBlocks& blocks, std::vector<GpuLane> lanes, Timeline* timeline);

	Status prepare(std::span<const probe::Sheet> sheets);
	Status planRuns(std::span<const find::FrontSlice> fronts);
	Status addRuns(const find::FrontSlice& front, std::size_t& offset);
	Status record();
	void recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set);

	GpuBlocks& blocks_;
	std::vector<GpuLane> lanes_;
	std::vector<find::SheetInBlock<surface::Plane>> cpu_lanes_; // the same lanes, for blocks the device does not hold
	Timeline* timeline_;
	GpuBlocks::Fields fields_; // per sheet
	std::unique_ptr<ClassifyWorkspace> workspace_;
	std::vector<std::shared_ptr<SheetRecords>> records_; // per sheet
	std::vector<std::uint32_t> lane_cells_;              // per lane: cells classified so far
	std::size_t lane_stride_;                            // between lanes in the uniform buffer
	std::size_t word_alignment_;                         // of a run's cells and words, in words
	std::uint32_t record_alignment_;                     // of a run's records
	std::vector<Run> runs_;                              // of the generation
	std::vector<find::FrontSlice> cpu_fronts_;           // of the generation
};

} // namespace vp::classify
