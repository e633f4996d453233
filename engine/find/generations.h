#pragma once

#include "base/ids.h"
#include "base/result.h"
#include "base/timeline.h"
#include "find/cell_signs.h"
#include "find/octant_queue.h"
#include "find/visited.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "seed/sheet_window.h"
#include "shared/slice_types.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <concepts>
#include <optional>
#include <span>
#include <stop_token>
#include <type_traits>
#include <vector>

namespace vp::find
{

// A sheet within a block: the unit that has a front and visited marks of its own. All lanes go in lock step, one call
// of the classifier for generation k of every lane.
//
// Window: what bounds the sheet, seed::SheetWindow or another that tells of faces and cells whether they reach into it.
template <class Surface, class Window = seed::SheetWindow>
struct SheetInBlock
{
	const grid::Block* block;
	Surface surface;
	VisitedMarks* visited;     // beginSlice() has been called; null where there is a queue, or nothing is searched
	std::vector<CellId> seeds; // generation 0; cells that turn out not to be cut do no harm
	// Where the block meets others or itself; null: nowhere. The lanes of a sheet stand in the order of the blocks,
	// from `sheet_lane` on: what lies across a seam in block b is queued in lane sheet_lane + b.
	const grid::BlockSeams* seams = nullptr;
	std::size_t sheet_lane = 0;
	// Cells that it turns down end the traversal: they are not queued. Empty: every cell may come.
	grid::CellFilter filter = {};
	// Where the sheet has one: cells whose section lies outside do not count as cut, edges outside lead nowhere.
	std::optional<Window> window = {};
	OctantQueue* queue = nullptr; // in place of the marks, and empty

	// Otherwise the block's cells are found in another way.
	bool isSearched() const { return visited || queue; }
	// Whether the cell is to be queued: it may come, and has not been queued yet.
	bool enters(CellId cell) const
	{
		return (queue ? queue->mark(cell) : visited->mark(cell)) && (!filter || filter(cell));
	}
};

// What a classifier is asked: a code for every cell of a lane's front (see slice_types.h).
struct FrontSlice
{
	std::size_t lane;
	std::span<const CellId> cells;
	std::span<std::uint32_t> codes;
};

template <class C>
concept Classifier = requires(C& c, std::span<const FrontSlice> fronts)
{
	{
		c.classify(fronts)
		} -> std::same_as<Status>;
};

// The cut cells of a lane in the order of their discovery.
struct CellCut
{
	std::vector<CellId> cells;        // every cell that was queued
	std::vector<std::uint32_t> codes; // its code, kCodeCut set where it is cut; kCodeWalk kept where the CPU walked it
	std::size_t cut_cells = 0;
	bool closed = false; // cells ascend, and what lies across a cut face of theirs in the block is listed too
	std::vector<std::uint32_t> generation_starts; // generations + 1 offsets into cells
	std::size_t steps =
	    0; // generations of all lanes up to this lane's last: more than its own where it was entered late

	std::size_t generations() const { return generation_starts.empty() ? 0 : generation_starts.size() - 1; }
	std::size_t frontMax() const
	{
		std::size_t widest = 0;
		for (std::size_t g = 0; g + 1 < generation_starts.size(); ++g)
			widest = std::max<std::size_t>(widest, generation_starts[g + 1] - generation_starts[g]);
		return widest;
	}
};

// Cells that are found without a traversal, as if they were all cut and had been its seeds.
inline CellCut oneGeneration(std::vector<CellId> cells)
{
	CellCut cut;
	cut.cells = std::move(cells);
	cut.cut_cells = cut.cells.size();
	cut.codes.assign(cut.cells.size(), shared::kCodeCut);
	cut.generation_starts.push_back(0);
	if (!cut.cells.empty())
		cut.generation_starts.push_back(static_cast<std::uint32_t>(cut.cells.size()));
	return cut;
}

// Queues the unqueued neighbors of the front [begin, end) of lane l across its cut faces. A boundary face of a block
// with seams is looked up among them; a block without pays nothing for those of others.
template <bool kHasSeams, class G, class Surface, class Window>
void expandFront(const G& grid, std::span<const SheetInBlock<Surface, Window>> lanes, std::size_t l, std::size_t begin,
                 std::size_t end, std::span<CellCut> cuts)
{
	const SheetInBlock<Surface, Window>& lane = lanes[l];
	CellCut& cut = cuts[l];
	const auto enqueue = [&](CellId neighbor)
	{
		if (lane.enters(neighbor))
			cut.cells.push_back(neighbor);
	};
	const auto cross = [&](CellId cell, int face)
	{
		if constexpr (!kHasSeams)
			grid.forEachNeighbor(cell, face, enqueue);
		else
		{
			bool on_boundary = true;
			grid.forEachNeighbor(cell, face,
			                     [&](CellId neighbor)
			                     {
				                     on_boundary = false;
				                     enqueue(neighbor);
			                     });
			if (!on_boundary)
				return;
			for (const grid::SeamLink& link : lane.seams->of(cell, static_cast<std::uint32_t>(face)))
			{
				const std::size_t across = lane.sheet_lane + link.block;
				if (lanes[across].isSearched() && lanes[across].enters(link.other))
					cuts[across].cells.push_back(link.other);
			}
		}
	};
	// Where a large face leads to several small cells, the window may hold a part of it that only some of them share.
	bool asks_every_cell = kHasSeams;
	if constexpr (requires { grid.hasLinks(); })
		asks_every_cell = asks_every_cell || grid.hasLinks();
	grid::CellFaces faces;
	for (std::size_t i = begin; i < end; ++i)
	{
		const CellId cell = cut.cells[i];
		const bool walked = cut.codes[i] & shared::kCodeWalk;
		if (walked)
			cut.codes[i] = classifyByWalk(grid, lane.surface, cell, faces);
		if (!(cut.codes[i] & shared::kCodeCut))
			continue;
		// Most cells lie within the window as a whole, and are not asked face by face.
		const bool at_rim = lane.window && !lane.window->holdsCell(grid, cell);
		if (at_rim && !walked)
			grid.cellFaces(cell, faces);
		// Later generations are mostly entered across an edge in the window, which is theirs too.
		if (at_rim && (begin == 0 || asks_every_cell) && !lane.window->meetsCell(grid, lane.surface, faces))
		{
			cut.codes[i] &= 0xFFu | shared::kCodeWalk;
			continue;
		}
		++cut.cut_cells;
		const auto crossFace = [&](int f)
		{
			if (!at_rim || lane.window->meetsFace(grid, lane.surface, faces[f]))
				cross(cell, f);
		};
		if (walked)
		{
			for (int f = 0; f < faces.size(); ++f)
				if (seed::isFaceCut(grid, lane.surface, faces[f]))
					crossFace(f);
			continue;
		}
		for (std::uint32_t bits = (cut.codes[i] >> shared::kCodeFacesShift) & 0xFFu; bits; bits &= bits - 1)
			crossFace(std::countr_zero(bits));
	}
}

// Those of one sheet, one after the other: across seams a front grows the lanes after it and before it, so its own ends
// are those of this generation.
template <class Surface, class Window>
void expandSheet(std::span<const SheetInBlock<Surface, Window>> lanes, std::span<const FrontSlice> fronts,
                 std::span<CellCut> cuts)
{
	for (const FrontSlice& front : fronts)
	{
		const SheetInBlock<Surface, Window>& lane = lanes[front.lane];
		const std::size_t end = cuts[front.lane].generation_starts.back();
		const std::size_t begin = end - front.cells.size();
		const auto expand = [&]<bool kHasSeams>(const auto& grid) {
			expandFront<kHasSeams, std::decay_t<decltype(grid)>, Surface, Window>(grid, lanes, front.lane, begin, end,
			                                                                      cuts);
		};
		std::visit([&](const auto& grid)
		           { lane.seams ? expand.template operator()<true>(grid) : expand.template operator()<false>(grid); },
		           lane.block->grid);
	}
}

// Sheets know nothing of each other: those of a wide generation are expanded on all cores. front_cells: of all fronts.
template <class Surface, class Window>
void expandSheets(std::span<const SheetInBlock<Surface, Window>> lanes, std::span<const FrontSlice> fronts,
                  std::size_t front_cells, std::span<CellCut> cuts)
{
	constexpr std::size_t kWorthSharing = 1024; // some 30 us of one core
	const auto ofSameSheet = [&](const FrontSlice& a, const FrontSlice& b)
	{ return lanes[a.lane].sheet_lane == lanes[b.lane].sheet_lane; };
	std::vector<std::span<const FrontSlice>> sheets;
	for (auto first = fronts.begin(); first != fronts.end();)
	{
		const auto last =
		    std::find_if(first, fronts.end(), [&](const FrontSlice& f) { return !ofSameSheet(*first, f); });
		sheets.emplace_back(first, last);
		first = last;
	}
	const auto expand = [&](std::size_t s) { expandSheet<Surface, Window>(lanes, sheets[s], cuts); };
	if (sheets.size() > 1 && front_cells >= kWorthSharing)
		tbb::parallel_for(std::size_t(0), sheets.size(), expand);
	else
		for (std::size_t s = 0; s < sheets.size(); ++s)
			expand(s);
}

// Breadth first, by generations: G(k+1) are the cells first met across the cut faces of G(k). Returns one CellCut a
// lane, or the classifier's error; a stop request ends the traversal between generations with what was found.
// timeline: sections "classify", which knows how wide the front is, and "expand" of each generation; or null.
template <class Surface, class Window = seed::SheetWindow, Classifier C>
Result<std::vector<CellCut>> breadthFirst(std::type_identity_t<std::span<SheetInBlock<Surface, Window>>> lanes,
                                          C& classifier, std::stop_token stop = {}, Timeline* timeline = nullptr)
{
	std::vector<CellCut> cuts(lanes.size());
	for (std::size_t l = 0; l < lanes.size(); ++l)
	{
		cuts[l].generation_starts.push_back(0);
		for (const CellId seed : lanes[l].seeds)
			if (lanes[l].enters(seed))
				cuts[l].cells.push_back(seed);
	}

	std::vector<FrontSlice> fronts;
	for (std::size_t step = 1; !stop.stop_requested(); ++step)
	{
		fronts.clear();
		std::size_t front_cells = 0;
		for (std::size_t l = 0; l < lanes.size(); ++l)
		{
			if (lanes[l].queue)
				lanes[l].queue->beginGeneration();
			CellCut& cut = cuts[l];
			const std::size_t begin = cut.generation_starts.back();
			if (begin == cut.cells.size())
				continue;
			cut.generation_starts.push_back(static_cast<std::uint32_t>(cut.cells.size()));
			cut.codes.resize(cut.cells.size());
			cut.steps = step;
			front_cells += cut.cells.size() - begin;
			fronts.push_back({l, std::span(cut.cells).subspan(begin), std::span(cut.codes).subspan(begin)});
		}
		if (fronts.empty())
			break;
		{
			const TimedSection section(timeline, "classify", front_cells);
			if (Status classified = classifier.classify(fronts); !classified)
				return classified.error();
		}
		const TimedSection section(timeline, "expand");
		expandSheets<Surface, Window>(lanes, fronts, front_cells, cuts);
	}
	// A stop leaves a generation queued that nothing is known about.
	for (CellCut& cut : cuts)
		cut.cells.resize(cut.codes.size());
	return cuts;
}

} // namespace vp::find
