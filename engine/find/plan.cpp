#include "find/plan.h"

#include "find/rows.h"
#include "find/spans.h"
#include "surface/gpu_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vp::find
{

namespace
{

constexpr std::array kStrategies{std::pair(Strategy::rows, "rows"),     std::pair(Strategy::spans, "spans"),
                                 std::pair(Strategy::cells, "cells"),   std::pair(Strategy::generations, "generations"),
                                 std::pair(Strategy::listed, "listed"), std::pair(Strategy::scan, "scan")};

/// One sheet in one block. sheet: null if something else replaces the sheets.
struct PlannedSheet
{
	const PlanRequest& request;
	const probe::Sheet* sheet;
	const grid::Block& block;
	bool has_seams;       // with other blocks
	bool is_unstructured; // as all blocks are
	bool lacks_neighbors; // some block does
	bool is_in_runs;      // some block is read in runs; other ranks have the others
};

/// Returns the reason why cells must be followed in generations in any grid, null if they need not.
const char* needsGenerations(const PlannedSheet& at)
{
	if (at.sheet->form)
		return at.sheet->form->isoValue() ? "the surface of one value, which only the CPU classifies"
		                                  : "a curved surface";
	if (at.request.has_threshold)
		return "the search ends at cells outside the threshold";
	if (at.request.seed_mode == seed::SeedMode::hotspot && (at.has_seams || at.sheet->window))
		return "only the piece at the hot spot is wanted";
	return nullptr;
}

const char* whyNotRows(const PlannedSheet& at)
{
	if (std::holds_alternative<grid::UniformGrid>(at.block.grid))
		return nullptr;
	const auto* rectilinear = std::get_if<grid::RectilinearGrid>(&at.block.grid);
	if (!rectilinear)
		return "the block has no straight axes";
	return hasStraightRows(*rectilinear) ? nullptr : "coordinates of an axis go up and down";
}

const char* whyNotSpans(const PlannedSheet& at)
{
	const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&at.block.grid);
	if (!curvilinear)
		return "the block is not curvilinear";
	return floodTakes(*curvilinear) ? nullptr : "rows are too long, or threads too many";
}

const char* whyNotCells(const PlannedSheet& at)
{
	const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&at.block.grid);
	if (!unstructured)
		return "the block is not unstructured";
	// With linked cells, the traversal enters all cells behind a large face that is partly in the window.
	return at.sheet->window && unstructured->hasLinks() ? "a window over faces that meet several smaller ones"
	                                                    : nullptr;
}

const char* whyNotScan(const PlannedSheet& at)
{
	if (!at.is_unstructured)
		return "not all blocks are unstructured";
	if (at.request.has_threshold)
		return "the search ends at cells outside the threshold";
	if (at.request.seed_mode != seed::SeedMode::automatic || at.request.looks_for_hot_spot)
		return "seeds are asked for";
	return nullptr;
}

/// Returns the reason why a strategy is not possible, null if it is.
const char* whyNot(Strategy strategy, const PlannedSheet& at)
{
	if (!at.sheet)
		return strategy == Strategy::listed ? nullptr : "cells of a grid index or a patch are listed";
	if (strategy == Strategy::listed)
		return "only cells of a grid index or a patch are listed";
	if (strategy == Strategy::generations)
		return nullptr;
	if (at.request.in_generations)
		return "generations are asked for";
	if (strategy == Strategy::scan)
		return whyNotScan(at);
	if (const char* why = needsGenerations(at))
		return why;
	return strategy == Strategy::rows    ? whyNotRows(at)
	       : strategy == Strategy::spans ? whyNotSpans(at)
	                                     : whyNotCells(at);
}

const char* whyGenerations(const PlannedSheet& at)
{
	if (const char* why = needsGenerations(at))
		return why;
	if (at.request.in_generations)
		return "asked for";
	// The usual strategy for this kind of block is not possible, or not wanted.
	const char* why = std::holds_alternative<grid::RectilinearGrid>(at.block.grid)   ? whyNotRows(at)
	                  : std::holds_alternative<grid::CurvilinearGrid>(at.block.grid) ? whyNotSpans(at)
	                                                                                 : whyNotCells(at);
	return why ? why : "the device classifies a generation at a time";
}

const char* whyTaken(Strategy strategy, const PlannedSheet& at)
{
	if (strategy == at.request.strategy)
		return "asked for";
	switch (strategy)
	{
	case Strategy::rows:
		return "straight axes: the plane's equation gives the cells";
	case Strategy::spans:
		return "curvilinear: runs of cells along i";
	case Strategy::cells:
		return "unstructured: cell by cell, in any order";
	case Strategy::listed:
		return std::holds_alternative<PatchName>(*at.request.surface) ? "the faces of a patch are known"
		                                                              : "cells of a grid index are known by subscripts";
	case Strategy::scan:
		if (!at.block.runs)
			return "the only cut: every cell is looked at once";
		return at.sheet->form && at.sheet->form->isoValue()
		           ? "in parts: the cells in those that have values on both sides are looked at"
		           : "in parts: the cells in the boxes that the sheet meets are looked at";
	case Strategy::generations:
		break;
	}
	return whyGenerations(at);
}

/// Returns true if neighbors would have to be built for this cut only, or need parts that it does without.
bool isOneOff(const PlannedSheet& at)
{
	return at.lacks_neighbors && (!at.request.another_follows || at.is_in_runs) && !at.request.in_generations &&
	       !at.request.device_first;
}

/// Returns the first possible strategy, in the order of their speed. A device gets generations instead of a search on
/// the CPU, unless the fastest way is wanted.
Strategy choose(const PlannedSheet& at)
{
	if (isOneOff(at) && !whyNot(Strategy::scan, at))
		return Strategy::scan;
	for (const auto& [strategy, name] : kStrategies)
	{
		const bool searches = strategy == Strategy::spans || strategy == Strategy::cells;
		if (strategy != Strategy::scan && !(searches && at.request.device_first) && !whyNot(strategy, at))
			return strategy;
	}
	return Strategy::generations;
}

/// Returns the reason why the CPU classifies although there is a device, null if the device does.
const char* whyNotOnDevice(const PlannedSheet& at, Strategy strategy, bool holds)
{
	if (!at.sheet)
		return "nothing to classify";
	if (strategy == Strategy::scan)
		return ""; // why_strategy tells
	if (!holds)
		return "CPU: the block passes a limit of the device";
	if (!at.sheet->form)
		return nullptr;
	if (at.sheet->form->isoValue())
		return ""; // why_strategy tells
	const auto surface = std::visit([](auto&& placed) { return surface::BlockSurface(placed); },
	                                at.sheet->form->placed(at.sheet->axes()));
	return surface::gpuSurfaceOf(surface) ? nullptr : "CPU: the expression is too long for the device";
}

BlockPlan planBlock(const PlannedSheet& at, bool has_device, bool holds)
{
	BlockPlan plan;
	plan.strategy = at.request.strategy.value_or(choose(at));
	plan.why_strategy = whyTaken(plan.strategy, at);
	const char* why_cpu = has_device ? whyNotOnDevice(at, plan.strategy, holds) : "";
	plan.classifier = why_cpu ? Processor::cpu : Processor::gpu;
	plan.why_classifier = why_cpu ? why_cpu : "";
	return plan;
}

/// Returns what of a request goes with linear cells alone, null if there is nothing.
const char* needsLinearCells(const PlanRequest& request)
{
	if (request.surface)
		return "a surface of the grid";
	if (std::ranges::any_of(request.sheets, [](const probe::Sheet& s) { return s.form && s.form->isoValue(); }))
		return "the surface of one value";
	if (request.has_threshold)
		return "a threshold";
	if (request.seed_mode != seed::SeedMode::automatic || request.looks_for_hot_spot)
		return "seeds";
	if (request.in_generations)
		return "generations";
	if (request.strategy && *request.strategy != Strategy::scan)
		return nameOf(*request.strategy);
	return nullptr;
}

/// The parts of curved cells have no neighbors.
Result<CutPlan> planRefined(const PlanRequest& request, const grid::BlockSet& blocks)
{
	if (const char* what = needsLinearCells(request))
		return Error{
		    ErrorKind::usage,
		    fmt::format("{}: not for curved cells, which a tolerance keeps; leave it out, or read the file with "
		                "`refine` 1",
		                what)};
	for (const grid::Block& block : blocks.blocks)
		if (!std::holds_alternative<grid::UnstructuredGrid>(block.grid))
			return Error{ErrorKind::usage,
			             fmt::format("block {} is structured, and other blocks have curved cells, which a tolerance "
			                         "keeps; read the files with `refine` 1",
			                         block.name)};
	const BlockPlan refined{Strategy::scan, Processor::cpu,
	                        "curved cells: those that the sheet may meet are refined, and their parts looked at once",
	                        ""};
	return CutPlan{{request.sheets.size(), std::vector(blocks.blocks.size(), refined)}, false};
}

} // namespace

std::optional<Strategy> strategyNamed(std::string_view name)
{
	for (const auto& [strategy, known] : kStrategies)
		if (name == known)
			return strategy;
	return std::nullopt;
}

const char* nameOf(Strategy strategy)
{
	return kStrategies[static_cast<std::size_t>(strategy)].second;
}

const char* nameOf(Processor classifier)
{
	return classifier == Processor::gpu ? "gpu" : "cpu";
}

std::string BlockPlan::reason() const
{
	return *why_classifier ? fmt::format("{}; {}", why_strategy, why_classifier) : why_strategy;
}

Result<CutPlan> planCut(const PlanRequest& request, const grid::BlockSet& blocks, const DeviceProfile* device)
{
	if (std::ranges::any_of(blocks.blocks, [](const grid::Block& block) { return block.curved != nullptr; }))
		return planRefined(request, blocks);
	CutPlan plan;
	const std::size_t sheets = request.surface ? 1 : request.sheets.size();
	const bool lacks_neighbors = !grid::hasNeighbors(blocks);
	const bool unstructured = std::ranges::all_of(blocks.blocks, [](const grid::Block& b)
	                                              { return std::holds_alternative<grid::UnstructuredGrid>(b.grid); });
	for (std::size_t s = 0; s < sheets; ++s)
	{
		std::vector<BlockPlan>& of_sheet = plan.sheets.emplace_back();
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			const PlannedSheet at{request,
			                      request.surface ? nullptr : &request.sheets[s],
			                      blocks.blocks[b],
			                      blocks.interfaces.of(b) != nullptr,
			                      unstructured,
			                      lacks_neighbors,
			                      grid::lacksParts(blocks)};
			if (request.strategy)
				if (const char* why = whyNot(*request.strategy, at))
					return Error{ErrorKind::usage,
					             fmt::format("{}: not for sheet {} in block {}: {}; leave it out, or take {}",
					                         nameOf(*request.strategy), s, blocks.blocks[b].name, why,
					                         nameOf(choose(at)))};
			of_sheet.push_back(planBlock(at, device, device && device->holds[b]));
			plan.needs_neighbors |= of_sheet.back().strategy != Strategy::scan && !grid::hasNeighbors(blocks.blocks[b]);
		}
	}
	return plan;
}

} // namespace vp::find
