#pragma once

#include "cut/cut.h"
#include "cut/request.h"
#include "find/find_block.h"
#include "find/generations.h"
#include "find/plan.h"
#include "find/queued_marks.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "seed/sheet_window.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace vp::cut
{

/// Sheets that are searched together: all planes of a request, since a device classifies one generation of all of them
/// at a time, or one curved sheet.
template <class Surface>
struct SheetGroup
{
	const CutRequest& request;
	std::vector<std::size_t> numbers; // indices of the sheets in the request
	std::vector<SheetCut> sheets;     // results are added to their cuts
	// Below, sheet s in block b has number s * blocks + b.
	std::vector<find::BlockPlan> plan;
	std::vector<Surface> surfaces;
	std::vector<grid::CellFilter> filters;

	bool needsGenerations(std::size_t i) const { return plan[i].strategy == find::Strategy::generations; }
	/// Returns true if the plan scans all cells. Then it does so for all sheets and blocks: it needs unstructured
	/// blocks only, and its reasons are the same for all sheets.
	bool isScanned() const { return !plan.empty() && plan.front().strategy == find::Strategy::scan; }
};

/// The search in generations of a group.
template <class Surface>
class GenerationSearch
{
public:
	/// The group must have its seeds. It and the stores (per block) must outlive the search.
	GenerationSearch(SheetGroup<Surface>& group, const grid::BlockSet& blocks,
	                 const std::vector<std::unique_ptr<find::BlockStores>>& stores)
	    : group_(group), block_count_(blocks.blocks.size())
	{
		for (std::size_t i = 0; i < group.plan.size(); ++i)
		{
			const SheetCut& sheet = group.sheets[i / block_count_];
			const std::size_t b = i % block_count_;
			auto& searched = sheets_.emplace_back(find::SheetInBlock<Surface>{.block = &blocks.blocks[b],
			                                                                  .surface = group.surfaces[i],
			                                                                  .visited = nullptr,
			                                                                  .seeds = {},
			                                                                  .seams = blocks.interfaces.of(b),
			                                                                  .first_block = i - b,
			                                                                  .filter = group.filters[i]});
			if (sheet.sheet.window)
				searched.window.emplace(sheet.sheet);
			if (!group.needsGenerations(i))
				continue;
			searched.seeds = sheet.seeds.cells[b];
			marks_.give(searched, group.request.visited, stores[b]->visited);
		}
	}

	std::span<const find::SheetInBlock<Surface>> sheets() const { return sheets_; }

	/// Adds the results to the sheets of the group.
	template <find::Classifier C>
	Status run(C& classifier, std::stop_token stop)
	{
		auto cuts = find::breadthFirst<Surface>(sheets_, classifier, stop, group_.request.timeline);
		if (!cuts)
			return cuts.error();
		for (std::size_t i = 0; i < cuts->size(); ++i)
			if (group_.needsGenerations(i))
				group_.sheets[i / block_count_].cuts[i % block_count_].found = std::move((*cuts)[i]);
		return Nothing{};
	}

private:
	SheetGroup<Surface>& group_;
	std::size_t block_count_;
	std::vector<find::SheetInBlock<Surface>> sheets_;
	find::QueuedMarks marks_;
};

} // namespace vp::cut
