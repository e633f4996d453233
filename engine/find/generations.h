#pragma once

#include "base/ids.h"
#include "base/parallel_for.h"
#include "base/result.h"
#include "base/timeline.h"
#include "find/cell_signs.h"
#include "find/octant_queue.h"
#include "find/visited.h"
#include "grid/block.h"
#include "grid/cell_filter.h"
#include "seed/sheet_window.h"
#include "shared/slice_types.h"

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

/// A sheet in a block: the unit of a traversal. It has a front and marks of its own. All of them go in lock step: one
/// call of the classifier serves generation k of all.
///
/// Window: the type that bounds the sheet. It says whether a face or a cell reaches into it, as seed::SheetWindow does.
template <class Surface, class Window = seed::SheetWindow>
struct SheetInBlock
{
	const grid::Block* block;
	Surface surface;
	VisitedMarks* visited;     // beginCut() has been called; null where there is a queue, or nothing is searched
	std::vector<CellId> seeds; // generation 0; cells that turn out not to be cut do no harm
	// The places where the block meets other blocks or itself; null: there are none.
	const grid::BlockSeams* seams = nullptr;
	// A sheet's blocks stand one after the other, in their order. This is the number of the first. A cell across a seam
	// in block b is queued at number first_block + b.
	std::size_t first_block = 0;
	// The traversal does not continue past cells that the filter rejects.
	grid::CellFilter filter = {};
	// Cells whose section lies outside the window are not cut. The traversal crosses no edge outside it.
	std::optional<Window> window = {};
	OctantQueue* queue = nullptr; // takes the place of the marks; empty at the start

	/// False: the cells of this block are found in another way, and none is queued.
	bool isSearched() const { return visited || queue; }
	/// Marks the cell. True when it is to be queued: it passes the filter, and was not queued before.
	bool enters(CellId cell) const
	{
		return (queue ? queue->mark(cell) : visited->mark(cell)) && (!filter || filter(cell));
	}
};

/// The cells of one generation of a sheet in a block. A classifier writes the code of each (shared/slice_types.h).
struct Front
{
	std::size_t sheet; // its number among the sheets in blocks that are traversed
	std::span<const CellId> cells;
	std::span<std::uint32_t> codes;
};

template <class C>
concept Classifier = requires(C& c, std::span<const Front> fronts)
{
	{
		c.classify(fronts)
		} -> std::same_as<Status>;
};

/// The cut cells of a sheet in a block, in the order in which they were found.
struct CellCut
{
	std::vector<CellId> cells;        // every cell that was queued
	std::vector<std::uint32_t> codes; // its code, kCodeCut set where it is cut; kCodeWalk kept where the CPU walked it
	std::size_t cut_cells = 0;
	std::size_t scanned = 0; // cells that a scan looked at; 0 where the cells were searched for
	bool closed = false;     // cells ascend, and what lies across a cut face of theirs in the block is listed too
	std::vector<std::uint32_t> generation_starts; // generations + 1 offsets into cells
	// Generations of the whole traversal until the last one here. That is more than generations() where the block was
	// entered late.
	std::size_t steps = 0;

	std::size_t generations() const { return generation_starts.empty() ? 0 : generation_starts.size() - 1; }
	std::size_t frontMax() const
	{
		std::size_t widest = 0;
		for (std::size_t g = 0; g + 1 < generation_starts.size(); ++g)
			widest = std::max<std::size_t>(widest, generation_starts[g + 1] - generation_starts[g]);
		return widest;
	}
};

/// Cells that are known without a traversal, as one generation. All count as cut.
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

/// Queues the neighbors of the front [begin, end) of sheet number l across cut faces. A boundary face is looked up
/// among the block's seams. A block without seams pays nothing for this.
template <bool kHasSeams, class G, class Surface, class Window>
void expandFront(const G& grid, std::span<const SheetInBlock<Surface, Window>> sheets, std::size_t l, std::size_t begin,
                 std::size_t end, std::span<CellCut> cuts)
{
	const SheetInBlock<Surface, Window>& sheet = sheets[l];
	CellCut& cut = cuts[l];
	const auto enqueue = [&](CellId neighbor)
	{
		if (sheet.enters(neighbor))
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
			for (const grid::SeamLink& link : sheet.seams->of(cell, static_cast<std::uint32_t>(face)))
			{
				const std::size_t across = sheet.first_block + link.block;
				if (sheets[across].isSearched() && sheets[across].enters(link.other))
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
			cut.codes[i] = classifyByWalk(grid, sheet.surface, cell, faces);
		if (!(cut.codes[i] & shared::kCodeCut))
			continue;
		// Most cells lie within the window as a whole, and are not asked face by face.
		const bool at_rim = sheet.window && !sheet.window->holdsCell(grid, cell);
		if (at_rim && !walked)
			grid.cellFaces(cell, faces);
		// Later generations are mostly entered across an edge in the window, which is theirs too.
		if (at_rim && (begin == 0 || asks_every_cell) && !sheet.window->meetsCell(grid, sheet.surface, faces))
		{
			cut.codes[i] &= 0xFFu | shared::kCodeWalk;
			continue;
		}
		++cut.cut_cells;
		const auto crossFace = [&](int f)
		{
			if (!at_rim || sheet.window->meetsFace(grid, sheet.surface, faces[f]))
				cross(cell, f);
		};
		if (walked)
		{
			for (int f = 0; f < faces.size(); ++f)
				if (seed::isFaceCut(grid, sheet.surface, faces[f]))
					crossFace(f);
			continue;
		}
		for (std::uint32_t bits = (cut.codes[i] >> shared::kCodeFacesShift) & 0xFFu; bits; bits &= bits - 1)
			crossFace(std::countr_zero(bits));
	}
}

/// Expands the fronts of one sheet's blocks one after the other. Across seams a front adds cells to other blocks of the
/// sheet, so the range of each front is taken from where its generation begins.
template <class Surface, class Window>
void expandSheet(std::span<const SheetInBlock<Surface, Window>> sheets, std::span<const Front> fronts,
                 std::span<CellCut> cuts)
{
	for (const Front& front : fronts)
	{
		const SheetInBlock<Surface, Window>& sheet = sheets[front.sheet];
		const std::size_t end = cuts[front.sheet].generation_starts.back();
		const std::size_t begin = end - front.cells.size();
		const auto expand = [&]<bool kHasSeams>(const auto& grid) {
			expandFront<kHasSeams, std::decay_t<decltype(grid)>, Surface, Window>(grid, sheets, front.sheet, begin, end,
			                                                                      cuts);
		};
		std::visit([&](const auto& grid)
		           { sheet.seams ? expand.template operator()<true>(grid) : expand.template operator()<false>(grid); },
		           sheet.block->grid);
	}
}

/// Expands all fronts. Sheets share nothing, so a wide generation uses all cores. front_cells: the sum over all fronts.
template <class Surface, class Window>
void expandSheets(std::span<const SheetInBlock<Surface, Window>> sheets, std::span<const Front> fronts,
                  std::size_t front_cells, std::span<CellCut> cuts)
{
	constexpr std::size_t kWorthSharing = 1024; // some 30 us of one core
	const auto ofSameSheet = [&](const Front& a, const Front& b)
	{ return sheets[a.sheet].first_block == sheets[b.sheet].first_block; };
	std::vector<std::span<const Front>> groups;
	for (auto first = fronts.begin(); first != fronts.end();)
	{
		const auto last = std::find_if(first, fronts.end(), [&](const Front& f) { return !ofSameSheet(*first, f); });
		groups.emplace_back(first, last);
		first = last;
	}
	const auto expand = [&](std::size_t s) { expandSheet<Surface, Window>(sheets, groups[s], cuts); };
	if (groups.size() > 1 && front_cells >= kWorthSharing)
		tracedFor(std::size_t(0), groups.size(), expand);
	else
		for (std::size_t s = 0; s < groups.size(); ++s)
			expand(s);
}

/// The paper's breadth-first traversal, by generations: G(k+1) are the cells first met across the cut faces of G(k).
/// Returns one CellCut for each sheet in a block, or the classifier's error. A stop request ends the traversal between
/// generations; what was found until then is returned. timeline: gets the sections "classify" (with the front's width)
/// and "expand" of each generation, and the counter "front"; may be null.
template <class Surface, class Window = seed::SheetWindow, Classifier C>
Result<std::vector<CellCut>> breadthFirst(std::type_identity_t<std::span<SheetInBlock<Surface, Window>>> sheets,
                                          C& classifier, std::stop_token stop = {}, Timeline* timeline = nullptr)
{
	std::vector<CellCut> cuts(sheets.size());
	for (std::size_t l = 0; l < sheets.size(); ++l)
	{
		cuts[l].generation_starts.push_back(0);
		for (const CellId seed : sheets[l].seeds)
			if (sheets[l].enters(seed))
				cuts[l].cells.push_back(seed);
	}

	std::vector<Front> fronts;
	std::size_t step = 1;
	for (; !stop.stop_requested(); ++step)
	{
		fronts.clear();
		std::size_t front_cells = 0;
		for (std::size_t l = 0; l < sheets.size(); ++l)
		{
			if (sheets[l].queue)
				sheets[l].queue->beginGeneration();
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
			if (timeline)
				timeline->count("front", front_cells);
			const TimedSection section(timeline, "classify", front_cells);
			if (Status classified = classifier.classify(fronts); !classified)
				return classified.error();
		}
		const TimedSection section(timeline, "expand");
		expandSheets<Surface, Window>(sheets, fronts, front_cells, cuts);
	}
	if (timeline && step > 1)
		timeline->count("front", 0);
	// A stop leaves a generation queued that nothing is known about.
	for (CellCut& cut : cuts)
		cut.cells.resize(cut.codes.size());
	return cuts;
}

} // namespace vp::find
