#include "base/timeline.h"
#include "classify/cpu_classifier.h"
#include "classify/gpu_surface_classifier.h"
#include "cut/cutter.h"
#include "cut/unmoved_sheets.h"
#include "find/lane_marks.h"
#include "seed/curved_seeds.h"
#include "surface/gpu_surface.h"

#include <algorithm>

namespace vp::cut
{

// Planes as ever, forms one after the other.
Result<Cut> Cutter::cutForms(const CutRequest& request, const std::vector<bool>& has_form, const Before& before,
                             std::stop_token stop)
{
	Cut planes;
	if (std::ranges::find(has_form, false) != has_form.end())
	{
		Before of_planes;
		for (std::size_t s = 0; s < before.size(); ++s)
			if (!has_form[s])
				of_planes.push_back(before[s]);
		Result<Cut> cut = cutAll(withoutSheets(request, has_form), of_planes, stop);
		if (!cut)
			return cut;
		planes = std::move(*cut);
	}
	Cut slice;
	slice.words = std::move(planes.words);
	const probe::Probe placed = probe::placed(request.probe);
	std::size_t plane = 0;
	for (std::size_t s = 0; s < has_form.size(); ++s)
	{
		if (!has_form[s])
		{
			slice.sheets.push_back(std::move(planes.sheets[plane++]));
			continue;
		}
		Result<SheetCut> cut = cutForm(request, placed.sheets[s],
		                               request.sheet_fields.empty() ? request.field : request.sheet_fields[s], stop);
		if (!cut)
			return cut.error();
		slice.sheets.push_back(std::move(*cut));
	}
	return slice;
}

namespace
{

// Cells that both admit.
std::function<bool(CellId)> both(std::function<bool(CellId)> a, std::function<bool(CellId)> b)
{
	if (!a || !b)
		return a ? a : b;
	return [a = std::move(a), b = std::move(b)](CellId cell) { return a(cell) && b(cell); };
}

} // namespace

Result<SheetCut> Cutter::cutForm(const CutRequest& request, const probe::Sheet& sheet,
                                 const std::optional<grid::FieldChoice>& field, std::stop_token stop)
{
	SheetCut slice;
	slice.shown = sheet;
	slice.sheet = sheet;
	slice.corners = request.corners;
	slice.field = field;
	const std::vector<surface::BlockSurface> surfaces = find::surfacesOf(blocks_, sheet, field, &ranges_);
	Admits admits = admitsOf(request);
	for (std::size_t b = 0; b < admits.size(); ++b)
		admits[b] = both(std::move(admits[b]), find::finiteCells(blocks_.blocks[b], surfaces[b]));
	{
		const TimedSection section(request.timeline, "seed");
		slice.seeds = seed::findSeeds(blocks_, surfaces, sheet, request.seeds.mode, admits);
	}
	const TimedSection section(request.timeline, "traverse");
	std::vector<CurvedLane> lanes;
	find::LaneMarks marks;
	for (std::size_t b = 0; b < blocks_.blocks.size(); ++b)
	{
		lanes.push_back({.block = &blocks_.blocks[b],
		                 .surface = surfaces[b],
		                 .visited = nullptr,
		                 .seeds = slice.seeds.cells[b],
		                 .seams = blocks_.interfaces.of(b),
		                 .sheet_lane = 0,
		                 .admits = admits[b]});
		marks.give(lanes.back(), request.visited, *visited_[b]);
		if (sheet.window)
			lanes.back().window.emplace(sheet);
	}
	auto cuts = traverseForm(request, lanes, stop);
	if (!cuts)
		return cuts.error();
	slice.cuts = std::move(*cuts);
	return slice;
}

Result<std::vector<find::CellCut>> Cutter::traverseForm(const CutRequest& request, std::span<CurvedLane> lanes,
                                                        std::stop_token stop)
{
	classify::CpuClassifier<surface::BlockSurface> cpu(lanes);
	std::vector<classify::GpuSurfaceClassifier::Lane> on_device;
	for (std::size_t b = 0; b < lanes.size(); ++b)
		on_device.push_back({b, surface::gpuSurfaceOf(lanes[b].surface)});
	const bool uses_device =
	    gpu_ && std::ranges::any_of(on_device, [](const auto& lane) { return lane.surface.has_value(); });
	if (!uses_device)
		return find::breadthFirst<surface::BlockSurface>(lanes, cpu, stop, request.timeline);
	auto gpu = classify::GpuSurfaceClassifier::create(
	    *gpu_, std::move(on_device), [&](auto fronts) { return cpu.classify(fronts); }, request.timeline);
	if (!gpu)
		return gpu.error();
	return find::breadthFirst<surface::BlockSurface>(lanes, **gpu, stop, request.timeline);
}

} // namespace vp::cut
