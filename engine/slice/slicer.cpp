#include "slice/slicer.h"

#include "base/timeline.h"
#include "slice/cpu_classifier.h"
#include "slice/gpu_blocks.h"
#include "slice/lane_marks.h"
#include "slice/unmoved_sheets.h"

#include <algorithm>
#include <cassert>

namespace vp::slice
{

SliceTicket::SliceTicket(std::stop_source stop, std::future<Result<Slice>> result)
    : stop_(std::move(stop)), result_(std::move(result))
{
}

SliceTicket::~SliceTicket()
{
	if (!result_.valid())
		return;
	cancel();
	result_.wait();
}

void SliceTicket::cancel()
{
	stop_.request_stop();
}

Result<Slice> SliceTicket::wait()
{
	return result_.get();
}

Slicer::Slicer(const grid::BlockSet& blocks) : blocks_(blocks), ranges_(blocks.blocks.size())
{
	for (const grid::Block& block : blocks.blocks)
	{
		visited_.push_back(std::make_unique<traverse::VisitedPool>(
		    std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid)));
		const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&block.grid);
		const std::size_t rows = curvilinear ? std::size_t(curvilinear->points()[1]) * curvilinear->points()[2] : 0;
		stores_.push_back(std::make_unique<Pool<traverse::SpanStore>>(
		    [rows] { return std::make_unique<traverse::SpanStore>(rows); }));
		const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&block.grid);
		const std::size_t cells = unstructured ? unstructured->cellCount() : 0;
		marks_.push_back(std::make_unique<Pool<traverse::CellMarks>>(
		    [cells] { return std::make_unique<traverse::CellMarks>(cells); }));
	}
}

Result<std::unique_ptr<Slicer>> Slicer::onDevice(gpu::Device& device, const grid::BlockSet& blocks,
                                                 const std::optional<FieldChoice>& field, Timeline* timeline)
{
	const TimedSection section(timeline, "upload");
	Result<std::unique_ptr<GpuBlocks>> uploaded = GpuBlocks::create(device, blocks);
	if (!uploaded)
		return uploaded.error();
	if (Result<GpuBlocks::Fields> values = (*uploaded)->fields({&field, 1}); !values)
		return values.error();
	auto slicer = std::make_unique<Slicer>(blocks);
	slicer->gpu_ = std::move(*uploaded);
	return slicer;
}

Slicer::~Slicer() = default;

std::size_t Slicer::blocksOnGpu() const
{
	return gpu_ ? gpu_->heldCount() : 0;
}

Slicer::Memory Slicer::memory() const
{
	Memory memory;
	const auto bytes = [](const auto& each) { return each.bytes(); };
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
		memory.marks += visited_[b]->bytes() + stores_[b]->sumOfIdle(bytes) + marks_[b]->sumOfIdle(bytes);
	memory.device = gpu_ ? gpu_->bytes() : 0;
	memory.marks += ranges_.bytes();
	return memory;
}

Result<CutPlan> Slicer::plan(const SliceRequest& request) const
{
	DeviceProfile device;
	if (gpu_)
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
			device.holds.push_back(gpu_->holds(b));
	return planCut(request, blocks_, gpu_ ? &device : nullptr);
}

SliceTicket Slicer::begin(SliceRequest request)
{
	std::stop_source stop;
	return {stop, std::async(std::launch::async, [this, request = std::move(request), token = stop.get_token()]
	                         { return run(request, token); })};
}

// The sheets, placed, with generation 0 of each; without faces that the threshold does not admit.
Slice Slicer::seedSheets(const SliceRequest& request, const Admits& admits) const
{
	const TimedSection section(request.timeline, "seed");
	Slice slice;
	for (const probe::Sheet& shown : probe::placed(request.probe).sheets)
	{
		const probe::Sheet sheet = probe::content(shown);
		const std::optional<FieldChoice>& field =
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
struct Slicer::Lanes
{
	std::vector<Lane> all; // lane s * blocks + b is sheet s in block b
	LaneMarks marks;
};

// What is found already is not traversed again.
Slicer::Lanes Slicer::makeLanes(const SliceRequest& request, const Slice& slice, const Found& found,
                                const Admits& admits)
{
	Lanes lanes;
	for (const SheetSlice& sheet : slice.sheets)
	{
		const std::size_t sheet_lane = lanes.all.size();
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
		{
			Lane& lane = lanes.all.emplace_back(Lane{.block = &blocks_.blocks[b],
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

Result<Slice> Slicer::run(const SliceRequest& request, std::stop_token stop)
{
	if (request.last)
		return cutMoved(request, stop);
	Result<Slice> cut = cutAll(request, {}, stop);
	if (cut)
		numberSheets(*cut);
	return cut;
}

Result<Slice> Slicer::cutMoved(const SliceRequest& request, std::stop_token stop)
{
	const std::vector<bool> unmoved = unmovedSheets(request);
	Before before;
	for (std::size_t s = 0; s < unmoved.size(); ++s)
		if (!unmoved[s])
			before.push_back(s < request.last->sheets.size() ? &request.last->sheets[s] : nullptr);
	Result<Slice> moved = before.empty() ? Slice() : cutAll(withoutSheets(request, unmoved), before, stop);
	if (!moved)
		return moved;
	numberSheets(*moved);
	return joinSheets(request, unmoved, std::move(*moved));
}

Slicer::Admits Slicer::admitsOf(const SliceRequest& request) const
{
	Admits admits(blocks_.blocks.size());
	if (request.threshold)
		for (std::size_t b = 0; b < admits.size(); ++b)
			admits[b] = cellsWithin(blocks_.blocks[b], *request.field, *request.threshold);
	return admits;
}

Result<Slice> Slicer::cutAll(const SliceRequest& request, const Before& before, std::stop_token stop)
{
	assert(request.field || !request.threshold);
	const Result<CutPlan> plan = this->plan(request);
	if (!plan)
		return plan.error();
	const Admits admits = admitsOf(request);
	if (request.surface)
		return showSurface(request, admits);
	if (const std::vector<bool> has_form = sheetsWithForm(request); std::ranges::find(has_form, true) != has_form.end())
		return cutForms(request, has_form, before, stop);

	Slice slice = seedSheets(request, admits);
	Found found = find(request, *plan, slice);
	spreadSeeds(request, before, found, slice);

	Lanes lanes = makeLanes(request, slice, found, admits);
	Result<std::vector<traverse::LaneCut>> cuts =
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

Slice Slicer::showSurface(const SliceRequest& request, const Admits& admits) const
{
	const TimedSection section(request.timeline, "traverse");
	Slice slice;
	SheetSlice& sheet = slice.sheets.emplace_back();
	sheet.field = request.sheet_fields.empty() ? request.field : request.sheet_fields.front();
	sheet.surface = request.surface;
	sheet.cuts = surfaceCells(blocks_, *request.surface, admits);
	sheet.seeds.faces_in_plane.resize(sheet.cuts.size());
	return slice;
}

Result<std::vector<traverse::LaneCut>> Slicer::traverseOnCpu(const SliceRequest& request, std::span<Lane> lanes,
                                                             std::stop_token stop)
{
	const TimedSection section(request.timeline, "traverse");
	CpuClassifier<surface::Plane> classifier(lanes);
	return traverse::breadthFirst<surface::Plane>(lanes, classifier, stop, request.timeline);
}

} // namespace vp::slice
