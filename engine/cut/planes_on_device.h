#pragma once

#include "base/result.h"
#include "classify/cpu_classifier.h"
#include "classify/gpu_classifier.h"
#include "classify/gpu_planes.h"
#include "cut/cut.h"
#include "find/generations.h"

#include <memory>
#include <span>
#include <vector>

namespace vp
{
class Timeline;
}

namespace vp::cut
{

/// The work of the device in a cut of plane sheets: it classifies all cells, and keeps the polygons for drawing.
class PlanesOnDevice
{
public:
	/// sheets: planes with their fields, in the order of the traversal. They must outlive this.
	static Result<std::unique_ptr<PlanesOnDevice>> create(classify::GpuBlocks& blocks, std::span<SheetCut> sheets,
	                                                      Timeline* timeline);

	classify::GpuClassifier& classifier() { return *classifier_; }

	/// Classifies the cells in SheetCut::cuts: all cells of a sheet in a block as one front. A list of cells gets the
	/// codes of the device.
	Status classifyKnown();

	/// Call this after the last generation, when SheetCut::cuts is complete. Gives the sheets their records. Adds what
	/// the device did not emit: cells that were walked, blocks that are not on the device, boundary faces in the plane.
	Status finish();

private:
	using PlaneInBlock = find::SheetInBlock<surface::Plane>;

	PlanesOnDevice(classify::GpuBlocks& blocks, std::span<SheetCut> sheets, Timeline* timeline);
	Status addHostRecords();
	find::CellCut walkedCells(std::size_t sheet, std::size_t block) const;

	classify::GpuBlocks& blocks_;
	std::span<SheetCut> sheets_;
	Timeline* timeline_;
	std::vector<PlaneInBlock> on_cpu_; // sheet s in block b: number s * blocks + b
	classify::CpuClassifier<surface::Plane> cpu_;
	std::vector<std::shared_ptr<classify::SheetRecords>> records_; // per sheet
	std::unique_ptr<classify::GpuClassifier> classifier_;
	std::vector<find::CellCut> fronts_; // like on_cpu_: of what was known as runs of cells
};

} // namespace vp::cut
