#include "slice/cut_plan.h"

#include "slice/gpu_surface_lane.h"
#include "slice/slicer.h"
#include "traverse/span_flood.h"
#include "traverse/span_rows.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace vp::slice
{

namespace
{

constexpr std::array kStrategies{std::pair(Strategy::rows, "rows"), std::pair(Strategy::spans, "spans"),
                                 std::pair(Strategy::cells, "cells"), std::pair(Strategy::generations, "generations"),
                                 std::pair(Strategy::listed, "listed")};

/// One sheet in one block. sheet: null where something else takes the place of the sheets.
struct Lane
{
	const SliceRequest& request;
	const probe::Sheet* sheet;
	const grid::Block& block;
	bool has_seams; // with other blocks
};

/// Why the cells have to be followed from one to the next in generations, whatever the grid; null where they do not.
const char* needsGenerations(const Lane& lane)
{
	if (lane.sheet->form)
		return lane.sheet->form->isoValue() ? "the surface of one value, which only the CPU classifies"
		                                    : "a curved surface";
	if (lane.request.threshold)
		return "the search ends at cells outside the threshold";
	if (lane.request.seeds.mode == seed::SeedMode::hotspot && (lane.has_seams || lane.sheet->window))
		return "only the piece at the hot spot is wanted";
	return nullptr;
}

const char* whyNotRows(const Lane& lane)
{
	if (std::holds_alternative<grid::UniformGrid>(lane.block.grid))
		return nullptr;
	const auto* rectilinear = std::get_if<grid::RectilinearGrid>(&lane.block.grid);
	if (!rectilinear)
		return "the block has no straight axes";
	return traverse::hasStraightRows(*rectilinear) ? nullptr : "coordinates of an axis go up and down";
}

const char* whyNotSpans(const Lane& lane)
{
	const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&lane.block.grid);
	if (!curvilinear)
		return "the block is not curvilinear";
	return traverse::floodTakes(*curvilinear) ? nullptr : "rows are too long, or threads too many";
}

const char* whyNotCells(const Lane& lane)
{
	const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&lane.block.grid);
	if (!unstructured)
		return "the block is not unstructured";
	// Where cells are linked the traversal enters all behind a large face that the window holds a part of.
	return lane.sheet->window && unstructured->hasLinks() ? "a window over faces that meet several smaller ones"
	                                                      : nullptr;
}

/// Why a strategy cannot be had; null where it can.
const char* whyNot(Strategy strategy, const Lane& lane)
{
	if (!lane.sheet)
		return strategy == Strategy::listed ? nullptr : "cells of a grid index or a patch are listed";
	if (strategy == Strategy::listed)
		return "only cells of a grid index or a patch are listed";
	if (strategy == Strategy::generations)
		return nullptr;
	if (const char* why = needsGenerations(lane))
		return why;
	if (lane.request.finder == Finder::traversal)
		return "generations are asked for";
	return strategy == Strategy::rows    ? whyNotRows(lane)
	       : strategy == Strategy::spans ? whyNotSpans(lane)
	                                     : whyNotCells(lane);
}

const char* whyGenerations(const Lane& lane)
{
	if (const char* why = needsGenerations(lane))
		return why;
	if (lane.request.finder == Finder::traversal)
		return "asked for";
	// The strategy of the block's kind could not be had, or was not to be taken.
	const char* why = std::holds_alternative<grid::RectilinearGrid>(lane.block.grid)   ? whyNotRows(lane)
	                  : std::holds_alternative<grid::CurvilinearGrid>(lane.block.grid) ? whyNotSpans(lane)
	                                                                                   : whyNotCells(lane);
	return why ? why : "the device classifies a generation at a time";
}

const char* whyTaken(Strategy strategy, const Lane& lane)
{
	if (strategy == lane.request.strategy)
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
		return std::holds_alternative<PatchName>(*lane.request.surface)
		           ? "the faces of a patch are known"
		           : "cells of a grid index are known by subscripts";
	case Strategy::generations:
		break;
	}
	return whyGenerations(lane);
}

/// The first that can be had, in the order of their speed. A device is given generations rather than a search on the
/// CPU, unless the fastest way is wanted.
Strategy choose(const Lane& lane)
{
	for (const auto& [strategy, name] : kStrategies)
	{
		const bool searches = strategy == Strategy::spans || strategy == Strategy::cells;
		if (!(searches && lane.request.finder == Finder::direct) && !whyNot(strategy, lane))
			return strategy;
	}
	return Strategy::generations;
}

/// Why the CPU classifies although there is a device; null where the device does.
const char* whyNotOnDevice(const Lane& lane, bool holds)
{
	if (!lane.sheet)
		return "nothing to classify";
	if (!holds)
		return "CPU: the block passes a limit of the device";
	if (!lane.sheet->form)
		return nullptr;
	if (lane.sheet->form->isoValue())
		return ""; // why_strategy tells
	const auto surface = std::visit([](auto&& placed) { return surface::BlockSurface(placed); },
	                                lane.sheet->form->placed(lane.sheet->axes()));
	return gpuSurfaceOf(surface) ? nullptr : "CPU: the expression is too long for the device";
}

BlockPlan planBlock(const Lane& lane, bool has_device, bool holds)
{
	BlockPlan plan;
	plan.strategy = lane.request.strategy.value_or(choose(lane));
	plan.why_strategy = whyTaken(plan.strategy, lane);
	const char* why_cpu = has_device ? whyNotOnDevice(lane, holds) : "";
	plan.classifier = why_cpu ? Classifier::cpu : Classifier::gpu;
	plan.why_classifier = why_cpu ? why_cpu : "";
	return plan;
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

const char* nameOf(Classifier classifier)
{
	return classifier == Classifier::gpu ? "gpu" : "cpu";
}

std::string BlockPlan::reason() const
{
	return *why_classifier ? fmt::format("{}; {}", why_strategy, why_classifier) : why_strategy;
}

Result<CutPlan> planCut(const SliceRequest& request, const grid::BlockSet& blocks, const DeviceProfile* device)
{
	CutPlan plan;
	const std::size_t sheets = request.surface ? 1 : request.probe.sheets.size();
	for (std::size_t s = 0; s < sheets; ++s)
	{
		std::vector<BlockPlan>& of_sheet = plan.sheets.emplace_back();
		for (std::size_t b = 0; b < blocks.blocks.size(); ++b)
		{
			const Lane lane{request, request.surface ? nullptr : &request.probe.sheets[s], blocks.blocks[b],
			                blocks.interfaces.of(b) != nullptr};
			if (request.strategy)
				if (const char* why = whyNot(*request.strategy, lane))
					return Error{ExitCode::usage,
					             fmt::format("{}: not for sheet {} in block {}: {}; leave it out, or take {}",
					                         nameOf(*request.strategy), s, blocks.blocks[b].name, why,
					                         nameOf(choose(lane)))};
			of_sheet.push_back(planBlock(lane, device, device && device->holds[b]));
		}
	}
	return plan;
}

} // namespace vp::slice
