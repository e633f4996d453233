#include "find/find_block.h"

#include "find/cells.h"
#include "find/rows.h"
#include "find/spans.h"

#include <cassert>

namespace vp::find
{

namespace
{

std::size_t rowsOfPoints(const grid::Block& block)
{
	const auto* curvilinear = std::get_if<grid::CurvilinearGrid>(&block.grid);
	return curvilinear ? std::size_t(curvilinear->points()[1]) * curvilinear->points()[2] : 0;
}

std::size_t unstructuredCells(const grid::Block& block)
{
	const auto* unstructured = std::get_if<grid::UnstructuredGrid>(&block.grid);
	return unstructured ? unstructured->cellCount() : 0;
}

} // namespace

BlockStores::BlockStores(const grid::Block& block)
    : visited(std::visit([](const auto& grid) { return grid.cellCount(); }, block.grid)),
      rows([count = rowsOfPoints(block)] { return std::make_unique<SpanStore>(count); }),
      marks([count = unstructuredCells(block)] { return std::make_unique<CellMarks>(count); })
{
}

std::size_t BlockStores::bytes() const
{
	const auto bytes_of = [](const auto& each) { return each.bytes(); };
	return visited.bytes() + rows.sumOfIdle(bytes_of) + marks.sumOfIdle(bytes_of);
}

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
