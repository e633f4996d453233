#include "cut/cutter.h"

#include "base/timeline.h"
#include "classify/cpu_classifier.h"
#include "classify/gpu_blocks.h"
#include "cut/unmoved_sheets.h"
#include "find/lane_marks.h"

#include <algorithm>
#include <cassert>

namespace vp::cut
{

find::PlanRequest planRequestOf(const CutRequest& request)
{
	return {.sheets = request.probe.sheets,
	        .surface = request.surface ? &*request.surface : nullptr,
	        .has_threshold = request.threshold.has_value(),
	        .seed_mode = request.seeds.mode,
	        .finder = request.finder,
	        .strategy = request.strategy};
}

CutTicket::CutTicket(std::stop_source stop, std::future<Result<Cut>> result)
    : stop_(std::move(stop)), result_(std::move(result))
{
}

CutTicket::~CutTicket()
{
	if (!result_.valid())
		return;
	cancel();
	result_.wait();
}

void CutTicket::cancel()
{
	stop_.request_stop();
}

Result<Cut> CutTicket::wait()
{
	return result_.get();
}

Cutter::Cutter(const grid::BlockSet& blocks) : blocks_(blocks), ranges_(blocks.blocks.size())
{
	for (const grid::Block& block : blocks.blocks)
	{
		visited_.push_back(std::make_unique<find::VisitedPool>(
		    std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid)));
		const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&block.grid);
		const std::size_t rows = curvilinear ? std::size_t(curvilinear->points()[1]) * curvilinear->points()[2] : 0;
		stores_.push_back(
		    std::make_unique<Pool<find::SpanStore>>([rows] { return std::make_unique<find::SpanStore>(rows); }));
		const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&block.grid);
		const std::size_t cells = unstructured ? unstructured->cellCount() : 0;
		marks_.push_back(
		    std::make_unique<Pool<find::CellMarks>>([cells] { return std::make_unique<find::CellMarks>(cells); }));
	}
}

Result<std::unique_ptr<Cutter>> Cutter::onDevice(gpu::Device& device, const grid::BlockSet& blocks,
                                                 const std::optional<grid::FieldChoice>& field, Timeline* timeline)
{
	const TimedSection section(timeline, "upload");
	Result<std::unique_ptr<classify::GpuBlocks>> uploaded = classify::GpuBlocks::create(device, blocks);
	if (!uploaded)
		return uploaded.error();
	if (Result<classify::GpuBlocks::Fields> values = (*uploaded)->fields({&field, 1}); !values)
		return values.error();
	auto slicer = std::make_unique<Cutter>(blocks);
	slicer->gpu_ = std::move(*uploaded);
	return slicer;
}

Cutter::~Cutter() = default;

std::size_t Cutter::blocksOnGpu() const
{
	return gpu_ ? gpu_->heldCount() : 0;
}

Cutter::Memory Cutter::memory() const
{
	Memory memory;
	const auto bytes = [](const auto& each) { return each.bytes(); };
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
		memory.marks += visited_[b]->bytes() + stores_[b]->sumOfIdle(bytes) + marks_[b]->sumOfIdle(bytes);
	memory.device = gpu_ ? gpu_->bytes() : 0;
	memory.marks += ranges_.bytes();
	return memory;
}

Result<find::CutPlan> Cutter::plan(const CutRequest& request) const
{
	find::DeviceProfile device;
	if (gpu_)
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
			device.holds.push_back(gpu_->holds(b));
	return find::planCut(planRequestOf(request), blocks_, gpu_ ? &device : nullptr);
}

CutTicket Cutter::begin(CutRequest request)
{
	std::stop_source stop;
	return {stop, std::async(std::launch::async, [this, request = std::move(request), token = stop.get_token()]
	                         { return run(request, token); })};
}

// The sheets, placed, with generation 0 of each; without faces that the threshold does not admit.
Cut Cutter::seedSheets(const CutRequest& request, const Admits& admits) const
{
	const TimedSection section(request.timeline, "seed");
	Cut slice;
	for (const probe::Sheet& shown : probe::placed(request.probe).sheets)
	{
		const probe::Sheet sheet = probe::content(shown);
		const std::optional<grid::FieldChoice>& field =
		    request.sheet_fields.empty() ? request.field : request.sheet_fields[slice.sheets.size()];
		slice.sheets.push_back({.shown = shown,
		                        .sheet = sheet,
		                        .corners = request.corners,
		                        .field = field,
		                        .seeds = seed::findSeeds(blocks_, sheet, request.seeds)});
		for (std::size_t b = 0; b < admits.size(); ++b)
			if (admits[b])
				std::erase_if(slice.sheets.back().seeds.faces_in_plane[b],
				              [&](const auto& face) { return !admits[b](face.cell); });
	}
	return slice;
}

// Lanes, and the marks that they refer to.
struct Cutter::Lanes
{
	std::vector<PlaneInBlock> all; // lane s * blocks + b is sheet s in block b
	find::LaneMarks marks;
};

// What is found already is not traversed again.
Cutter::Lanes Cutter::makeLanes(const CutRequest& request, const Cut& slice, const Found& found, const Admits& admits)
{
	Lanes lanes;
	for (const SheetCut& sheet : slice.sheets)
	{
		const std::size_t sheet_lane = lanes.all.size();
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
		{
			PlaneInBlock& lane = lanes.all.emplace_back(PlaneInBlock{.block = &blocks_.blocks[b],
			                                                         .surface = sheet.sheet.plane(),
			                                                         .visited = nullptr,
			                                                         .seeds = {},
			                                                         .seams = blocks_.interfaces.of(b),
			                                                         .sheet_lane = sheet_lane,
			                                                         .admits = admits[b]});
			if (sheet.sheet.window)
				lane.window.emplace(sheet.sheet);
			if (found[lanes.all.size() - 1])
				continue;
			lane.seeds = sheet.seeds.cells[b];
			lanes.marks.give(lane, request.visited, *visited_[b]);
		}
	}
	return lanes;
}

Result<Cut> Cutter::run(const CutRequest& request, std::stop_token stop)
{
	if (request.last)
		return cutMoved(request, stop);
	Result<Cut> cut = cutAll(request, {}, stop);
	if (cut)
		numberSheets(*cut);
	return cut;
}

Result<Cut> Cutter::cutMoved(const CutRequest& request, std::stop_token stop)
{
	const std::vector<bool> unmoved = unmovedSheets(request);
	Before before;
	for (std::size_t s = 0; s < unmoved.size(); ++s)
		if (!unmoved[s])
			before.push_back(s < request.last->sheets.size() ? &request.last->sheets[s] : nullptr);
	Result<Cut> moved = before.empty() ? Cut() : cutAll(withoutSheets(request, unmoved), before, stop);
	if (!moved)
		return moved;
	numberSheets(*moved);
	return joinSheets(request, unmoved, std::move(*moved));
}

Cutter::Admits Cutter::admitsOf(const CutRequest& request) const
{
	Admits admits(blocks_.blocks.size());
	if (request.threshold)
		for (std::size_t b = 0; b < admits.size(); ++b)
			admits[b] = find::cellsWithin(blocks_.blocks[b], *request.field, *request.threshold);
	return admits;
}

Result<Cut> Cutter::cutAll(const CutRequest& request, const Before& before, std::stop_token stop)
{
	assert(request.field || !request.threshold);
	const Result<find::CutPlan> plan = this->plan(request);
	if (!plan)
		return plan.error();
	const Admits admits = admitsOf(request);
	if (request.surface)
		return showSurface(request, admits);
	if (const std::vector<bool> has_form = sheetsWithForm(request); std::ranges::find(has_form, true) != has_form.end())
		return cutForms(request, has_form, before, stop);

	Cut slice = seedSheets(request, admits);
	Found found = find(request, *plan, slice);
	spreadSeeds(request, before, found, slice);

	Lanes lanes = makeLanes(request, slice, found, admits);
	Result<std::vector<find::CellCut>> cuts =
	    gpu_ ? traverseOnGpu(request, lanes.all, found, slice, stop) : traverseOnCpu(request, lanes.all, stop);
	if (!cuts)
		return cuts.error();
	for (std::size_t lane = 0; lane < cuts->size(); ++lane)
		slice.sheets[lane / blocks_.blocks.size()].cuts.push_back(
		    std::move(found[lane] ? *found[lane] : (*cuts)[lane]));
	if (gpu_)
		if (Status added = addHostRecords(request.timeline, slice); !added)
			return added.error();
	return slice;
}

Cut Cutter::showSurface(const CutRequest& request, const Admits& admits) const
{
	const TimedSection section(request.timeline, "traverse");
	Cut slice;
	SheetCut& sheet = slice.sheets.emplace_back();
	sheet.field = request.sheet_fields.empty() ? request.field : request.sheet_fields.front();
	sheet.surface = request.surface;
	sheet.cuts = find::listedCells(blocks_, *request.surface, admits);
	sheet.seeds.faces_in_plane.resize(sheet.cuts.size());
	return slice;
}

Result<std::vector<find::CellCut>> Cutter::traverseOnCpu(const CutRequest& request, std::span<PlaneInBlock> lanes,
                                                         std::stop_token stop)
{
	const TimedSection section(request.timeline, "traverse");
	classify::CpuClassifier<surface::Plane> classifier(lanes);
	return find::breadthFirst<surface::Plane>(lanes, classifier, stop, request.timeline);
}

} // namespace vp::cut
