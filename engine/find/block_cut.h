#pragma once

#include "find/generations.h"
#include "find/span_cut.h"

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace vp::find
{

/// The cut cells that a strategy found for a sheet in one block: cells with their case codes, or runs of cells.
struct BlockCut
{
	std::variant<CellCut, SpanCut> found;

	bool hasSpans() const { return std::holds_alternative<SpanCut>(found); }
	const CellCut& cells() const { return std::get<CellCut>(found); } // where it has no spans
	const SpanCut& spans() const { return std::get<SpanCut>(found); } // where it has them

	std::size_t cutCells() const { return hasSpans() ? spans().cells.cut : cells().cut_cells; }
	/// Number of cells that a search looked at, cut or not. 0 after a scan.
	std::size_t touchedCells() const
	{
		if (hasSpans())
			return spans().cells.looked_at;
		return cells().scanned > 0 ? 0 : cells().cells.size();
	}
	/// Number of cells that a scan looked at: all cells of the block. 0 without a scan.
	std::size_t scannedCells() const { return hasSpans() ? 0 : cells().scanned; }
	/// Number of generations until the last cell of the block was found; 0 without generations.
	std::size_t steps() const { return hasSpans() ? spans().classified_at_once : cells().steps; }
	/// Number of cells in the widest generation.
	std::size_t frontMax() const
	{
		return hasSpans() ? spans().classified_at_once * spans().cells.cut : cells().frontMax();
	}
};

/// Calls visit(CellId) for every cut cell of a block.
template <class Visit>
void forEachCutCell(const grid::Block&, const CellCut& cut, Visit&& visit)
{
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeCut)
			visit(cut.cells[i]);
}
template <class Visit>
void forEachCutCell(const grid::Block& block, const BlockCut& cut, Visit&& visit)
{
	std::visit([&](const auto& found) { forEachCutCell(block, found, visit); }, cut.found);
}

/// Returns the cut cells as one generation for a device, without cells beside the window, which a device would count as
/// cut.
inline CellCut asOneFront(const grid::Block& block, const BlockCut& cut)
{
	std::vector<CellId> cells;
	cells.reserve(cut.cutCells());
	forEachCutCell(block, cut, [&](CellId cell) { cells.push_back(cell); });
	CellCut front = oneGeneration(std::move(cells));
	front.steps = front.cells.empty() ? 0 : 1;
	return front;
}

} // namespace vp::find
