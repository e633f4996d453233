#pragma once

#include "classify/gpu_blocks.h"
#include "classify/gpu_surface_lane.h"
#include "find/generations.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace vp::classify
{

// Classifies the cells of curved surfaces on the device: one submission serves a generation of all lanes, and words
// come back; the meshes are the CPU's to make. One per slice; used by one thread.
//
// The words are those of the CPU classifier, but for cells where a value's sign is not certain in floats: they come
// back as kCodeWalk, so that the traversal decides them in double.
class GpuSurfaceClassifier
{
public:
	// Classifies fronts of lanes that the device has no surface for, or in blocks that it does not hold.
	using OnCpu = std::function<Status(std::span<const find::FrontSlice>)>;

	struct Lane
	{
		std::size_t block;
		std::optional<surface::Curved> surface;
	};

	// `lanes` in the order in which they are traversed. Sections "classify" go to the timeline, which may be null.
	static Result<std::unique_ptr<GpuSurfaceClassifier>> create(GpuBlocks& blocks, std::vector<Lane> lanes,
	                                                            OnCpu on_cpu, Timeline* timeline);
	~GpuSurfaceClassifier(); // adds the times to the timeline
	GpuSurfaceClassifier(const GpuSurfaceClassifier&) = delete;
	GpuSurfaceClassifier& operator=(const GpuSurfaceClassifier&) = delete;

	Status classify(std::span<const find::FrontSlice> fronts);

private:
	// A dispatch.
	struct Run
	{
		const find::FrontSlice* front;
		std::size_t begin; // of its cells in the front
		std::size_t count;
		std::size_t offset; // of its cells and words in the buffers
	};

	GpuSurfaceClassifier(GpuBlocks& blocks, std::vector<Lane> lanes, OnCpu on_cpu, Timeline* timeline);

	Status prepare();
	Status makePipelines();
	Status reserve(std::size_t axis_texels);
	Status planRuns(std::span<const find::FrontSlice> fronts);
	Status submit();
	void recordRun(VkCommandBuffer commands, const Run& run, VkDescriptorSet set);

	GpuBlocks& blocks_;
	std::vector<Lane> lanes_;
	OnCpu on_cpu_;
	Timeline* timeline_;
	std::vector<std::shared_ptr<const gpu::Pipeline>> pipelines_; // per lane; null where the CPU classifies
	std::unique_ptr<ClassifyWorkspace> workspace_;
	std::size_t lane_stride_;    // between lanes in the uniform buffer
	std::size_t word_alignment_; // of a run's cells and words, in words
	std::vector<Run> runs_;      // of the generation
	std::vector<find::FrontSlice> cpu_fronts_;
};

} // namespace vp::classify
