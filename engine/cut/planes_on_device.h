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

/// The device's part in a cut of plane sheets: it classifies all their cells, and keeps their polygons for drawing.
class PlanesOnDevice
{
public:
	/// sheets: planes, with their fields; in the order of what is traversed. They outlive it.
	static Result<std::unique_ptr<PlanesOnDevice>> create(classify::GpuBlocks& blocks, std::span<SheetCut> sheets,
	                                                      Timeline* timeline);

	classify::GpuClassifier& classifier() { return *classifier_; }

	/// Classifies what is known already, in SheetCut::cuts: all cells of a sheet in a block as one front. Where these
	/// are cells, they get the device's codes.
	Status classifyKnown();

	/// After the last generation, when SheetCut::cuts is complete: the sheets get their records, with what the device
	/// did not emit added: cells that were walked, blocks that it does not hold, boundary faces in the plane.
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
