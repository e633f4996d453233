#include "base/timeline.h"
#include "slice/gpu_blocks.h"
#include "slice/gpu_classifier.h"
#include "slice/host_records.h"
#include "slice/slice_meshes.h"
#include "slice/slicer.h"
#include "slice/unmoved_sheets.h"

#include <algorithm>

namespace vp::slice
{

// For all sheets of a slice in all blocks; lane s * blocks + b is sheet s in block b.
Result<std::unique_ptr<GpuClassifier>> Slicer::gpuClassifier(const Slice& slice, Timeline* timeline)
{
	std::vector<probe::Sheet> sheets;
	std::vector<std::optional<FieldChoice>> fields;
	for (const SheetSlice& sheet : slice.sheets)
	{
		sheets.push_back(sheet.sheet);
		fields.push_back(sheet.field);
	}
	std::vector<GpuLane> lanes;
	for (std::uint32_t s = 0; s < slice.sheets.size(); ++s)
		for (std::uint32_t b = 0; b < blocks_.blocks.size(); ++b)
			lanes.push_back({s, b});
	return GpuClassifier::create(*gpu_, sheets, fields, std::move(lanes), timeline);
}

// The cells that are known make one front of each lane.
Status Slicer::classifyFound(GpuClassifier& classifier, Found& found)
{
	std::vector<traverse::FrontSlice> fronts;
	for (std::size_t lane = 0; lane < found.size(); ++lane)
		if (found[lane] && !found[lane]->cells.empty())
			fronts.push_back({lane, found[lane]->cells, found[lane]->words});
	return fronts.empty() ? Status(Nothing{}) : classifier.classify(fronts);
}

// As the traversal does with cells that a classifier leaves to it.
void Slicer::walkFound(std::span<const Lane> lanes, Found& found)
{
	grid::CellFaces faces;
	for (std::size_t l = 0; l < found.size(); ++l)
	{
		if (!found[l])
			continue;
		traverse::LaneCut& cut = *found[l];
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
			if (cut.words[i] & shared::kWordWalk)
				cut.words[i] =
				    std::visit([&](const auto& grid)
				               { return traverse::classifyByWalk(grid, lanes[l].surface, cut.cells[i], faces); },
				               lanes[l].block->grid);
	}
}

void Slicer::takeRecords(GpuClassifier& classifier, Slice& slice)
{
	const std::vector<std::shared_ptr<SheetRecords>> records = classifier.finish();
	for (std::size_t s = 0; s < records.size(); ++s)
		slice.sheets[s].records = records[s];
	slice.words = gpu_->words();
}

Result<std::vector<traverse::LaneCut>> Slicer::traverseOnGpu(const SliceRequest& request, std::span<Lane> lanes,
                                                             Found& found, Slice& slice, std::stop_token stop)
{
	const TimedSection section(request.timeline, "traverse");
	Result<std::unique_ptr<GpuClassifier>> classifier = gpuClassifier(slice, request.timeline);
	if (!classifier)
		return classifier.error();
	if (Status done = classifyFound(**classifier, found); !done)
		return done.error();
	walkFound(lanes, found);
	auto cuts = traverse::breadthFirst<surface::Plane>(lanes, **classifier, stop, request.timeline);
	takeRecords(**classifier, slice);
	return cuts;
}

void Slicer::forgetValues()
{
	ranges_.forget();
	if (gpu_)
		gpu_->forgetFields();
}

Result<Slice> Slicer::regather(const Slice& kept, Timeline* timeline)
{
	Slice slice = kept;
	numberSheets(slice);
	if (!gpu_ || std::ranges::any_of(slice.sheets, [](const SheetSlice& s) { return !s.isPlane(); }))
		return slice; // meshes gather their values when they are made
	const TimedSection section(timeline, "emit");
	Result<std::unique_ptr<GpuClassifier>> classifier = gpuClassifier(slice, timeline);
	if (!classifier)
		return classifier.error();
	Found known;
	for (const SheetSlice& sheet : slice.sheets)
		for (const traverse::LaneCut& cut : sheet.cuts)
			known.push_back(cut);
	if (Status done = classifyFound(**classifier, known); !done)
		return done.error();
	takeRecords(**classifier, slice);
	if (Status added = addHostRecords(timeline, slice); !added)
		return added.error();
	return slice;
}

// What the device did not emit: cells that were walked, blocks that it does not hold, boundary faces in the plane.
Status Slicer::addHostRecords(Timeline* timeline, Slice& slice) const
{
	const TimedSection section(timeline, "emit");
	for (SheetSlice& sheet : slice.sheets)
	{
		std::vector<traverse::LaneCut> left;
		for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
			left.push_back(gpu_->holds(b) ? walkedCells(sheet.cuts[b]) : sheet.cuts[b]);
		const SheetMesh mesh = buildMesh(blocks_, sheet.sheet, cellCuts(left, sheet));
		if (mesh.polygons() == 0)
			continue;
		const auto records = recordsFromMesh(blocks_, sheet.sheet, mesh, sheet.field);
		if (Status added = sheet.records->appendHostRecords(records); !added)
			return added;
	}
	return Nothing{};
}

} // namespace vp::slice
