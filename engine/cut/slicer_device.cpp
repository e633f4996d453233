#include "base/timeline.h"
#include "classify/gpu_blocks.h"
#include "classify/gpu_classifier.h"
#include "cut/cutter.h"
#include "cut/slice_meshes.h"
#include "cut/unmoved_sheets.h"
#include "mesh/build_mesh.h"
#include "mesh/host_records.h"

#include <algorithm>

namespace vp::cut
{

// For all sheets of a slice in all blocks; lane s * blocks + b is sheet s in block b.
Result<std::unique_ptr<classify::GpuClassifier>> Cutter::gpuClassifier(const Cut& slice, Timeline* timeline)
{
	std::vector<probe::Sheet> sheets;
	std::vector<std::optional<grid::FieldChoice>> fields;
	for (const SheetCut& sheet : slice.sheets)
	{
		sheets.push_back(sheet.sheet);
		fields.push_back(sheet.field);
	}
	std::vector<classify::GpuLane> lanes;
	for (std::uint32_t s = 0; s < slice.sheets.size(); ++s)
		for (std::uint32_t b = 0; b < blocks_.blocks.size(); ++b)
			lanes.push_back({s, b});
	return classify::GpuClassifier::create(*gpu_, sheets, fields, std::move(lanes), timeline);
}

// The cells that are known make one front of each lane.
Status Cutter::classifyFound(classify::GpuClassifier& classifier, Found& found)
{
	std::vector<find::FrontSlice> fronts;
	for (std::size_t lane = 0; lane < found.size(); ++lane)
		if (found[lane] && !found[lane]->cells.empty())
			fronts.push_back({lane, found[lane]->cells, found[lane]->words});
	return fronts.empty() ? Status(Nothing{}) : classifier.classify(fronts);
}

// As the traversal does with cells that a classifier leaves to it.
void Cutter::walkFound(std::span<const PlaneInBlock> lanes, Found& found)
{
	grid::CellFaces faces;
	for (std::size_t l = 0; l < found.size(); ++l)
	{
		if (!found[l])
			continue;
		find::CellCut& cut = *found[l];
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
			if (cut.words[i] & shared::kCodeWalk)
				cut.words[i] = std::visit([&](const auto& grid)
				                          { return find::classifyByWalk(grid, lanes[l].surface, cut.cells[i], faces); },
				                          lanes[l].block->grid);
	}
}

void Cutter::takeRecords(classify::GpuClassifier& classifier, Cut& slice)
{
	const std::vector<std::shared_ptr<classify::SheetRecords>> records = classifier.finish();
	for (std::size_t s = 0; s < records.size(); ++s)
		slice.sheets[s].records = records[s];
	slice.words = gpu_->words();
}

Result<std::vector<find::CellCut>> Cutter::traverseOnGpu(const CutRequest& request, std::span<PlaneInBlock> lanes,
                                                         Found& found, Cut& slice, std::stop_token stop)
{
	const TimedSection section(request.timeline, "traverse");
	Result<std::unique_ptr<classify::GpuClassifier>> classifier = gpuClassifier(slice, request.timeline);
	if (!classifier)
		return classifier.error();
	if (Status done = classifyFound(**classifier, found); !done)
		return done.error();
	walkFound(lanes, found);
	auto cuts = find::breadthFirst<surface::Plane>(lanes, **classifier, stop, request.timeline);
	takeRecords(**classifier, slice);
	return cuts;
}

void Cutter::forgetValues()
{
	ranges_.forget();
	if (gpu_)
		gpu_->forgetFields();
}

Result<Cut> Cutter::regather(const Cut& kept, Timeline* timeline)
{
	Cut slice = kept;
	numberSheets(slice);
	if (!gpu_ || std::ranges::any_of(slice.sheets, [](const SheetCut& s) { return !s.isPlane(); }))
		return slice; // meshes gather their values when they are made
	const TimedSection section(timeline, "emit");
	Result<std::unique_ptr<classify::GpuClassifier>> classifier = gpuClassifier(slice, timeline);
	if (!classifier)
		return classifier.error();
	Found known;
	for (const SheetCut& sheet : slice.sheets)
		for (const find::CellCut& cut : sheet.cuts)
			known.push_back(cut);
	if (Status done = classifyFound(**classifier, known); !done)
		return done.error();
	takeRecords(**classifier, slice);
	if (Status added = addHostRecords(timeline, slice); !added)
		return added.error();
	return slice;
}

namespace
{

// The cells of a cut that the CPU walked: those whose records the GPU left empty.
find::CellCut walkedCells(const find::CellCut& cut)
{
	find::CellCut walked;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.words[i] & shared::kCodeWalk && cut.words[i] & shared::kCodeCut)
		{
			walked.cells.push_back(cut.cells[i]);
			walked.words.push_back(cut.words[i]);
		}
	walked.cut_cells = walked.cells.size();
	return walked;
}

} // namespace

// What the device did not emit: cells that were walked, blocks that it does not hold, boundary faces in the plane.
Status Cutter::addHostRecords(Timeline* timeline, Cut& slice) const
{
	const TimedSection section(timeline, "emit");
	for (SheetCut& sheet : slice.sheets)
	{
		std::vector<find::CellCut> left;
		for (std::size_t b = 0; b < sheet.cuts.size(); ++b)
			left.push_back(gpu_->holds(b) ? walkedCells(sheet.cuts[b]) : sheet.cuts[b]);
		const mesh::SheetMesh mesh = mesh::buildMesh(blocks_, sheet.sheet, cellCuts(left, sheet));
		if (mesh.polygons() == 0)
			continue;
		const auto records = mesh::recordsFromMesh(blocks_, sheet.sheet, mesh, sheet.field);
		if (Status added = sheet.records->appendHostRecords(records); !added)
			return added;
	}
	return Nothing{};
}

} // namespace vp::cut
