#include "find/block_stores.h"

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

} // namespace vp::find
