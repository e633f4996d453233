#include "cut/cutter.h"

#include "base/timeline.h"
#include "classify/cpu_classifier.h"
#include "classify/gpu_blocks.h"
#include "classify/gpu_classifier.h"
#include "classify/gpu_surfaces.h"
#include "cut/planes_on_device.h"
#include "cut/refined_cut.h"
#include "cut/reuse.h"
#include "cut/sheet_group.h"
#include "cut/spread_seeds.h"
#include "find/find_block.h"
#include "find/listed.h"
#include "find/scan.h"
#include "seed/curved_seeds.h"

#include <algorithm>
#include <cassert>

namespace vp::cut
{

CutTicket::~CutTicket()
{
	if (!result_.valid())
		return;
	cancel();
	result_.wait();
}

Cutter::Cutter(const grid::BlockSet& blocks) : blocks_(blocks), ranges_(blocks.blocks.size())
{
	for (const grid::Block& block : blocks.blocks)
		stores_.push_back(std::make_unique<find::BlockStores>(block));
	if (refine::hasCurvedCells(blocks))
		refiner_ = std::make_unique<refine::Refiner>(blocks);
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
	auto cutter = std::make_unique<Cutter>(blocks);
	cutter->gpu_ = std::move(*uploaded);
	return cutter;
}

Cutter::~Cutter() = default;

std::size_t Cutter::blocksOnGpu() const
{
	return gpu_ ? gpu_->heldCount() : 0;
}

Cutter::Memory Cutter::memory() const
{
	Memory memory;
	for (const auto& stores : stores_)
		memory.marks += stores->bytes();
	memory.marks += ranges_.bytes() + (refiner_ ? refiner_->bytes() : 0);
	memory.device = gpu_ ? gpu_->bytes() : 0;
	return memory;
}

Result<find::CutPlan> Cutter::plan(const CutRequest& request) const
{
	find::DeviceProfile device;
	if (gpu_)
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
			device.holds.push_back(gpu_->holds(b));
	return find::planCut(request.forPlan(), blocks_, gpu_ ? &device : nullptr);
}

Result<std::vector<seed::SheetSeeds>> Cutter::seedsOf(const CutRequest& request)
{
	const Result<find::CutPlan> plan = this->plan(request);
	if (!plan)
		return plan.error();
	std::vector<seed::SheetSeeds> seeds;
	for (std::size_t s = 0; s < request.probe.sheets.size(); ++s)
		seeds.push_back(std::move(request.probe.sheets[s].form ? curvedSheetOf(request, *plan, s).sheets.front().seeds
		                                                       : planesOf(request, *plan, {s}).sheets.front().seeds));
	return seeds;
}

CutTicket Cutter::begin(CutRequest request)
{
	std::stop_source stop;
	return {stop, std::async(std::launch::async, [this, request = std::move(request), token = stop.get_token()]
	                         { return run(request, token); })};
}

Result<Cut> Cutter::run(const CutRequest& request, std::stop_token stop)
{
	if (!request.last || refiner_)
	{
		Result<Cut> cut = refiner_ ? cutRefined(*refiner_, blocks_, request, stop) : cutAll(request, {}, stop);
		if (cut)
			numberSheets(*cut);
		return cut;
	}
	const Reuse reuse = reuseOf(request);
	Result<Cut> moved = reuse.was.empty() ? Cut() : cutAll(reuse.moved, reuse.was, stop);
	if (!moved)
		return moved;
	numberSheets(*moved);
	return withResting(request, reuse, std::move(*moved));
}

Result<Cut> Cutter::cutAll(const CutRequest& request, const Previous& previous, std::stop_token stop)
{
	assert(request.field || !request.threshold);
	const Result<find::CutPlan> plan = this->plan(request);
	if (!plan)
		return plan.error();
	assert(!plan->needs_neighbors);
	if (request.surface)
		return listSurface(request);

	Cut cut;
	cut.sheets.resize(request.probe.sheets.size());
	const auto take = [&](auto& group)
	{
		for (std::size_t i = 0; i < group.numbers.size(); ++i)
			cut.sheets[group.numbers[i]] = std::move(group.sheets[i]);
	};
	std::vector<std::size_t> planes;
	for (std::size_t s = 0; s < cut.sheets.size(); ++s)
		if (!request.probe.sheets[s].form)
			planes.push_back(s);
	if (!planes.empty())
	{
		SheetGroup<surface::Plane> group = planesOf(request, *plan, planes);
		if (Status done = search(group, previous, stop); !done)
			return done.error();
		take(group);
		if (gpu_)
			cut.warnings = gpu_->warnings();
	}
	for (std::size_t s = 0; s < cut.sheets.size(); ++s)
	{
		if (!request.probe.sheets[s].form)
			continue;
		SheetGroup<surface::BlockSurface> group = curvedSheetOf(request, *plan, s);
		if (Status done = search(group, stop); !done)
			return done.error();
		take(group);
	}
	return cut;
}

Cut Cutter::listSurface(const CutRequest& request) const
{
	const TimedSection section(request.timeline, "traverse");
	Cut cut;
	SheetCut& sheet = cut.sheets.emplace_back();
	sheet.field = request.fieldOf(0);
	sheet.surface = request.surface;
	sheet.cuts = find::listedCells(blocks_, *request.surface, thresholdFilters(request));
	sheet.seeds.faces_in_plane.resize(sheet.cuts.size());
	return cut;
}

std::vector<grid::CellFilter> Cutter::thresholdFilters(const CutRequest& request) const
{
	std::vector<grid::CellFilter> filters(blocks_.blocks.size());
	if (request.threshold)
		for (std::size_t b = 0; b < filters.size(); ++b)
			filters[b] = find::cellsWithin(blocks_.blocks[b], *request.field, *request.threshold);
	return filters;
}

template <class Surface>
SheetGroup<Surface> Cutter::groupOf(const CutRequest& request, const find::CutPlan& plan,
                                    std::vector<std::size_t> numbers) const
{
	SheetGroup<Surface> group{request, std::move(numbers), {}, {}, {}, {}};
	const std::vector<probe::Sheet> placed = probe::placed(request.probe).sheets;
	const std::vector<grid::CellFilter> filters = thresholdFilters(request);
	for (const std::size_t s : group.numbers)
	{
		SheetCut& sheet = group.sheets.emplace_back();
		sheet.shown = placed[s];
		sheet.sheet = probe::content(placed[s]);
		sheet.corners = request.corners;
		sheet.hanging = request.hanging;
		sheet.field = request.fieldOf(s);
		sheet.cuts.resize(blocks_.blocks.size());
		group.plan.insert(group.plan.end(), plan.sheets[s].begin(), plan.sheets[s].end());
		group.filters.insert(group.filters.end(), filters.begin(), filters.end());
	}
	return group;
}

SheetGroup<surface::Plane> Cutter::planesOf(const CutRequest& request, const find::CutPlan& plan,
                                            std::vector<std::size_t> numbers) const
{
	const TimedSection section(request.timeline, "seed");
	SheetGroup<surface::Plane> group = groupOf<surface::Plane>(request, plan, std::move(numbers));
	for (std::size_t s = 0; s < group.sheets.size(); ++s)
	{
		SheetCut& sheet = group.sheets[s];
		group.surfaces.insert(group.surfaces.end(), blocks_.blocks.size(), sheet.sheet.plane());
		if (group.isScanned())
			continue;
		std::vector<bool> needs_none;
		if (request.seeds.mode != seed::SeedMode::hotspot) // where a block without a seed shows nothing
			for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
				needs_none.push_back(group.plan[s * blocks_.blocks.size() + b].strategy == find::Strategy::rows);
		sheet.seeds = request.given_seeds ? (*request.given_seeds)[group.numbers[s]]
		                                  : seed::findSeeds(blocks_, sheet.sheet, request.seeds, needs_none);
		for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
			if (const grid::CellFilter& filter = group.filters[b])
				std::erase_if(sheet.seeds.faces_in_plane[b], [&](const auto& face) { return !filter(face.cell); });
	}
	return group;
}

SheetGroup<surface::BlockSurface> Cutter::curvedSheetOf(const CutRequest& request, const find::CutPlan& plan,
                                                        std::size_t number)
{
	SheetGroup<surface::BlockSurface> group = groupOf<surface::BlockSurface>(request, plan, {number});
	SheetCut& sheet = group.sheets.front();
	group.surfaces = find::surfacesOf(blocks_, sheet.sheet, sheet.field, group.isScanned() ? nullptr : &ranges_);
	for (std::size_t b = 0; b < group.filters.size(); ++b)
		group.filters[b] =
		    grid::both(std::move(group.filters[b]), find::finiteCells(blocks_.blocks[b], group.surfaces[b]));
	if (group.isScanned())
		return group;
	const TimedSection section(request.timeline, "seed");
	sheet.seeds = request.given_seeds
	                  ? (*request.given_seeds)[number]
	                  : seed::findSeeds(blocks_, group.surfaces, sheet.sheet, request.seeds.mode, group.filters);
	return group;
}

template <class Surface>
Status Cutter::scan(SheetGroup<Surface>& group) const
try
{
	const TimedSection section(group.request.timeline, "traverse");
	const std::size_t blocks = blocks_.blocks.size();
	for (std::size_t s = 0; s < group.sheets.size(); ++s)
	{
		SheetCut& sheet = group.sheets[s];
		std::optional<seed::SheetWindow> window;
		if (sheet.sheet.window)
			window.emplace(sheet.sheet);
		std::vector<find::Scan> scans;
		for (std::size_t b = 0; b < blocks; ++b)
			scans.push_back(find::scanCells(blocks_.blocks[b], group.surfaces[s * blocks + b],
			                                window ? &*window : nullptr, group.filters[s * blocks + b]));
		sheet.seeds.cells.resize(blocks);
		sheet.seeds.faces_in_plane = find::facesToShow(blocks_, scans);
		sheet.seeds.faces_of_cut_cells.assign(blocks, {});
		for (std::size_t b = 0; b < blocks; ++b)
		{
			if (blocks_.blocks[b].runs && blocks_.blocks[b].runs->isShare())
				for (const find::FlatFace& flat : scans[b].flat)
					if (flat.shown)
						sheet.seeds.faces_of_cut_cells[b].push_back(flat.face);
			sheet.cuts[b].found = std::move(scans[b].cut);
		}
	}
	return Nothing{};
}
catch (const grid::WrongPoint& wrong)
{
	return Error{ErrorKind::input, wrong.what()};
}

// Finds what needs no generations.
void Cutter::findKnown(SheetGroup<surface::Plane>& group)
{
	std::optional<TimedSection> section;
	for (std::size_t i = 0; i < group.plan.size(); ++i)
	{
		SheetCut& sheet = group.sheets[i / blocks_.blocks.size()];
		const std::size_t b = i % blocks_.blocks.size();
		// If a block has no seed, the piece at the hot spot lies in another block.
		if (group.needsGenerations(i) ||
		    (group.request.seeds.mode == seed::SeedMode::hotspot && sheet.seeds.cells[b].empty()))
			continue;
		if (!section)
			section.emplace(group.request.timeline, "traverse");
		sheet.cuts[b] = find::findInBlock(group.plan[i].strategy, blocks_.blocks[b], sheet.sheet, sheet.seeds.cells[b],
		                                  *stores_[b]);
		if (gpu_ && !sheet.cuts[b].hasSpans())
			sheet.cuts[b].found = find::asOneFront(blocks_.blocks[b], sheet.cuts[b]);
	}
}

// Adds seeds, if they are requested and a traversal follows.
void Cutter::addSeeds(SheetGroup<surface::Plane>& group, const Previous& previous) const
{
	const CutRequest& request = group.request;
	if (!request.seeds.lattice || request.threshold || request.seeds.mode == seed::SeedMode::hotspot)
		return;
	const TimedSection section(request.timeline, "seed");
	for (std::size_t i = 0; i < group.plan.size(); ++i)
	{
		const std::size_t s = i / blocks_.blocks.size();
		const std::size_t b = i % blocks_.blocks.size();
		if (group.needsGenerations(i))
			spreadSeeds(blocks_.blocks[b], b, previous.empty() ? nullptr : previous[group.numbers[s]], group.sheets[s]);
		group.sheets[s].seeds.rim[b] = {};
	}
}

Status Cutter::search(SheetGroup<surface::Plane>& group, const Previous& previous, std::stop_token stop)
{
	if (group.isScanned())
		return scan(group);
	findKnown(group);
	addSeeds(group, previous);
	GenerationSearch<surface::Plane> generations(group, blocks_, stores_);
	if (!gpu_)
	{
		const TimedSection section(group.request.timeline, "traverse");
		classify::CpuClassifier<surface::Plane> classifier(generations.sheets());
		return generations.run(classifier, stop);
	}
	std::optional<TimedSection> section(std::in_place, group.request.timeline, "traverse");
	auto device = PlanesOnDevice::create(*gpu_, group.sheets, group.request.timeline);
	if (!device)
		return device.error();
	if (Status done = (*device)->classifyKnown(); !done)
		return done;
	if (Status done = generations.run((*device)->classifier(), stop); !done)
		return done;
	section.reset();
	return (*device)->finish();
}

Status Cutter::search(SheetGroup<surface::BlockSurface>& group, std::stop_token stop)
{
	if (group.isScanned())
		return scan(group);
	const TimedSection section(group.request.timeline, "traverse");
	GenerationSearch<surface::BlockSurface> generations(group, blocks_, stores_);
	classify::CpuClassifier<surface::BlockSurface> cpu(generations.sheets());
	if (!gpu_)
		return generations.run(cpu, stop);
	auto surface = classify::surfaceOnGpu(*gpu_, group.surfaces);
	if (!surface)
		return surface.error();
	auto gpu = classify::GpuClassifier::create(
	    *gpu_, std::move(*surface), [&](auto fronts) { return cpu.classify(fronts); }, group.request.timeline);
	return gpu ? generations.run(**gpu, stop) : Status(gpu.error());
}

void Cutter::forgetValues()
{
	ranges_.forget();
	if (refiner_)
		refiner_->forgetValues();
	if (gpu_)
		gpu_->forgetFields();
}

Result<Cut> Cutter::regather(const Cut& kept, Timeline* timeline)
{
	Cut cut = kept;
	numberSheets(cut);
	if (!gpu_ || std::ranges::any_of(cut.sheets, [](const SheetCut& s) { return !s.isPlane(); }))
		return cut; // meshes gather their values when they are made
	const TimedSection section(timeline, "emit");
	Cut classified = cut; // the device knows nothing of windows, so its codes are not kept
	auto device = PlanesOnDevice::create(*gpu_, classified.sheets, timeline);
	if (!device)
		return device.error();
	if (Status done = (*device)->classifyKnown(); !done)
		return done.error();
	if (Status done = (*device)->finish(); !done)
		return done.error();
	for (std::size_t s = 0; s < cut.sheets.size(); ++s)
		cut.sheets[s].records = classified.sheets[s].records;
	cut.warnings = gpu_->warnings();
	return cut;
}

} // namespace vp::cut
