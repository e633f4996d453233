#include "session/met_parts.h"

#include "session/session.h"
#include "surface/curved.h"

#include <algorithm>
#include <functional>

namespace vp::session
{

namespace
{

// A block without cells in place of a grid that is still in its file.
grid::BlockSet standIn(const read::PackedGrid& packed)
{
	grid::BlockSet set;
	grid::Block& block = set.blocks.emplace_back();
	block.grid = grid::UnstructuredGrid::listed({}, {});
	block.fields = packed.fields;
	block.bounds = packed.bounds();
	return set;
}

// Returns true if the settings look at nothing but cells that the sheets meet, where they are in the file.
bool looksAtCutAlone(const view::ViewSpec& spec)
{
	return meetsFewValues(spec) && !needsNeighbors(spec) && !spec.input.displace && spec.input.displace_by.empty() &&
	       !spec.input.cell_to_point && !spec.look.logarithmic && !spec.machine.visited &&
	       spec.machine.classify != view::Classify::gpu;
}

using Meets = std::function<bool(const Box&)>;

Meets meetsOf(const probe::Sheet& placed)
{
	if (!placed.form)
		return [plane = probe::content(placed).plane()](const Box& box) { return plane.meets(box); };
	const surface::BlockSurface surface =
	    std::visit([](auto&& curved) { return surface::BlockSurface(curved); }, placed.form->placed(placed.axes()));
	return [surface](const Box& box) { return surface.meets(box); };
}

} // namespace

std::optional<std::vector<std::uint64_t>> metParts(const view::ViewSpec& spec, const read::PackedGrid& grid)
{
	if (!looksAtCutAlone(spec))
		return std::nullopt;
	const grid::BlockSet whole = standIn(grid);
	const Result<view::ResolvedView> view = view::resolve(spec, whole);
	if (!view)
		return std::nullopt;
	const probe::Probe placed = probe::placed(view->probe);
	const find::PlanRequest request{.sheets = placed.sheets,
	                                .seed_mode = view->seeds.mode,
	                                .looks_for_hot_spot = view->seeds.outside != seed::OutsidePolicy::nearest,
	                                .strategy = spec.machine.strategy};
	const Result<find::CutPlan> plan = find::planCut(request, whole, nullptr);
	const auto isScan = [](const std::vector<find::BlockPlan>& of_sheet)
	{ return of_sheet.front().strategy == find::Strategy::scan; };
	if (!plan || !std::ranges::all_of(plan->sheets, isScan))
		return std::nullopt;
	std::vector<Meets> sheets;
	for (const probe::Sheet& sheet : placed.sheets)
		sheets.push_back(meetsOf(sheet));
	std::vector<std::uint64_t> met;
	for (std::size_t part = 0; part < grid.parts.size(); ++part)
		if (!grid.parts[part].empty() &&
		    std::ranges::any_of(sheets, [&](const Meets& meets) { return meets(grid.parts[part]); }))
			met.push_back(part);
	if (met.empty())
		met.push_back(0);
	return met;
}

} // namespace vp::session
