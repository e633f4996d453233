#pragma once

#include "exhaustive.h"
#include "slice/slicer.h"
#include "slice/stats.h"

namespace vp::test
{

// One sheet through one block set, the way a user's slice goes.
struct SlicedSheet
{
	slice::SheetSlice slice;
	slice::SheetMesh mesh;

	std::vector<CellId> cutCells(std::size_t block = 0) const // ascending
	{
		std::vector<CellId> cells;
		const traverse::LaneCut& cut = slice.cuts[block];
		for (std::size_t i = 0; i < cut.cells.size(); ++i)
			if (cut.words[i] & shared::kWordCut)
				cells.push_back(cut.cells[i]);
		return sorted(std::move(cells));
	}
	std::size_t cutCellCount() const
	{
		std::size_t count = 0;
		for (const traverse::LaneCut& cut : slice.cuts)
			count += cut.cut_cells;
		return count;
	}
	std::size_t touched() const
	{
		std::size_t count = 0;
		for (const traverse::LaneCut& cut : slice.cuts)
			count += cut.cells.size();
		return count;
	}
};

inline SlicedSheet cut(slice::Slicer& slicer, const TestPlane& plane, const seed::SeedOptions& seeds = {},
                       slice::Finder finder = slice::Finder::traversal,
                       const std::optional<probe::Window>& window = std::nullopt)
{
	slice::SliceRequest request;
	request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
	request.probe.sheets[0].window = window;
	request.seeds = seeds;
	request.finder = finder;
	slice::Slice slice = std::move(slicer.cut(std::move(request)).value());
	SlicedSheet sheet{{}, slice.mesh(slicer.blocks(), 0)};
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
