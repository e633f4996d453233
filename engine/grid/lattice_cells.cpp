#include "grid/lattice_cells.h"

#include "grid/block.h"

namespace vp::grid
{

std::span<const CellId> LazyCellPlaces::of(const Block& block)
{
	std::call_once(filled_,
	               [&]
	               {
		               const auto& grid = std::get<UnstructuredGrid>(block.grid);
		               stored_.assign(block.hidden_lattice->cellCount(), kNoCell);
		               for (std::size_t c = 0; c < grid.cellCount(); ++c)
			               stored_[grid.sourceCell(static_cast<CellId>(c))] = static_cast<CellId>(c);
	               });
	return stored_;
}

std::optional<LatticeCells> latticeCellsOf(const Block& block)
{
	if (block.hidden_lattice)
		return LatticeCells(*block.hidden_lattice, block.cell_places->of(block));
	return std::visit(
	    [](const auto& grid) -> std::optional<LatticeCells>
	    {
		    if constexpr (std::is_base_of_v<Lattice, std::decay_t<decltype(grid)>>)
			    return LatticeCells(grid);
		    else
			    return std::nullopt;
	    },
	    block.grid);
}

} // namespace vp::grid
