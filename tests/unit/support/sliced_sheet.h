#pragma once

#include "cut/cutter.h"
#include "exhaustive.h"
#include "measure/stats.h"

namespace vp::test
{

// One sheet through one block set, the way a user's slice goes.
struct SlicedSheet
{
	const grid::BlockSet* blocks;
	cut::SheetCut slice;
	mesh::SheetMesh mesh;

	std::vector<CellId> cutCells(std::size_t block = 0) const // ascending
	{
		std::vector<CellId> cells;
		find::forEachCutCell(blocks->blocks[block], slice.cuts[block], [&](CellId cell) { cells.push_back(cell); });
		return sorted(std::move(cells));
	}
	std::size_t cutCellCount() const
	{
		std::size_t count = 0;
		for (const find::BlockCut& cut : slice.cuts)
			count += cut.cutCells();
		return count;
	}
	std::size_t touched() const
	{
		std::size_t count = 0;
		for (const find::BlockCut& cut : slice.cuts)
			count += cut.touchedCells();
		return count;
	}
};

// How the cells are found: in generations, as the paper has it, or in the fastest way that is possible.
enum class Search
{
	generations,
	fastest
};

inline cut::CutRequest inGenerations()
{
	cut::CutRequest request;
	request.in_generations = true;
	return request;
}

inline SlicedSheet cut(cut::Cutter& cutter, const TestPlane& plane, const seed::SeedOptions& seeds = {},
                       Search search = Search::generations, const std::optional<probe::Window>& window = std::nullopt)
{
	cut::CutRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.probe.sheets[0].window = window;
	request.seeds = seeds;
	request.in_generations = search == Search::generations;
	cut::Cut slice = std::move(cutter.cut(std::move(request)).value());
	SlicedSheet sheet{&cutter.blocks(), {}, slice.mesh(cutter.blocks(), 0)};
	sheet.slice = std::move(slice.sheets[0]);
	return sheet;
}

inline grid::BlockSet setOf(const grid::Block& block)
{
	grid::BlockSet set;
	set.blocks.push_back(block);
	return set;
}

} // namespace vp::test
