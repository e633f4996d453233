#include "find/find_block.h"

#include "find/cells.h"
#include "find/rows.h"
#include "find/spans.h"

#include <cassert>

namespace vp::find
{

BlockCut findInBlock(Strategy strategy, const grid::Block& block, const probe::Sheet& sheet,
                     std::span<const CellId> seeds, BlockStores& stores)
{
	const surface::Plane plane = sheet.plane();
	const std::optional<seed::SheetWindow> limits =
	    sheet.window ? std::optional<seed::SheetWindow>(sheet) : std::nullopt;
	const seed::SheetWindow* window = limits ? &*limits : nullptr;
	if (strategy == Strategy::cells)
		return {floodCells(std::get<grid::UnstructuredGrid>(block.grid), plane, block.bounds, window, seeds,
		                   *stores.marks.borrow())};
	if (strategy == Strategy::spans)
		return {floodSpans(std::get<grid::CurvilinearGrid>(block.grid), block.bounds, plane, window, seeds,
		                   *stores.rows.borrow())};
	assert(strategy == Strategy::rows);
	if (const auto* uniform = std::get_if<grid::UniformGrid>(&block.grid))
		return {rowSpans(*uniform, plane, window)};
	return {rowSpans(std::get<grid::RectilinearGrid>(block.grid), plane, window)};
}

} // namespace vp::find
