#include "vectors/elsewhere.h"

#include "vectors/cell_across.h"
#include "vectors/lattice_axes.h"

#include <algorithm>

namespace vp::vectors
{

namespace
{

template <grid::Grid G>
FarCell farCellOf(const G& grid, std::span<const BlockVectors> vectors, const BlockBorders& borders,
                  const mesh::BlockCell& cell)
{
	FarCell far{};
	far.id = cell;
	const LatticeAxes axes = axesOf(grid);
	const grid::CellPoints points = grid.cellPoints(cell.cell);
	for (int v = 0; v < points.size; ++v)
	{
		const int source = sourceCorner(axes, v);
		far.corners[source] = grid.point(points.id[v]);
		for (std::size_t time = 0; time < vectors.size(); ++time)
			if (vectors[time].known() && !vectors[time].onCells())
				far.vectors[time][source] = vectors[time].at(grid.sourcePoint(points.id[v]));
	}
	for (std::size_t time = 0; time < vectors.size(); ++time)
		if (vectors[time].known() && vectors[time].onCells())
			far.vectors[time][0] = vectors[time].at(grid.sourceCell(cell.cell));
	for (int f = 0; f < 6; ++f)
	{
		mesh::BlockCell& next = far.across[sourceFace(axes, f)];
		next = {cell.block, grid.neighbor(cell.cell, f)};
		if (next.cell == kNoCell)
			next = borders.inSameLattice(cell, f).value_or(next);
	}
	return far;
}

// In each direction one.
template <class Visit>
void forCellsAround(const grid::Lattice& lattice, CellId cell, const Visit& visit)
{
	const auto at = lattice.cellIndex(cell);
	const auto low = [&](int axis) { return at[axis] - (at[axis] > 0 ? 1 : 0); };
	const auto high = [&](int axis) { return std::min(at[axis] + 1, lattice.cells()[axis] - 1); };
	for (std::uint32_t k = low(2); k <= high(2); ++k)
		for (std::uint32_t j = low(1); j <= high(1); ++j)
			for (std::uint32_t i = low(0); i <= high(0); ++i)
				visit(lattice.cell(i, j, k));
}

std::uint64_t keyOf(const mesh::BlockCell& cell)
{
	return std::uint64_t(cell.block) << 32 | cell.cell;
}

} // namespace

std::span<const mesh::BlockCell> BlockBorders::acrossFace(const mesh::BlockCell& cell, int face) const
{
	const auto found = across[cell.block].find(faceKey(cell.cell, face));
	return found == across[cell.block].end() ? std::span<const mesh::BlockCell>() : std::span(found->second);
}

std::optional<mesh::BlockCell> BlockBorders::inSameLattice(const mesh::BlockCell& cell, int face) const
{
	for (const mesh::BlockCell& other : acrossFace(cell, face))
		if (whole[other.block] == whole[cell.block] && is_lattice[other.block])
			return other;
	return std::nullopt;
}

std::optional<std::uint32_t> Elsewhere::numberOf(const mesh::BlockCell& cell) const
{
	const auto found = numbers_.find(keyOf(cell));
	return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

void Elsewhere::add(const FarCell& cell)
{
	if (numbers_.try_emplace(keyOf(cell.id), static_cast<std::uint32_t>(cells_.size())).second)
		cells_.push_back(cell);
}

std::vector<FarCell> cellsAround(const grid::BlockSet& blocks, std::span<const BlockVectors> vectors,
                                 const BlockBorders& borders, const mesh::BlockCell& cell)
{
	std::vector<FarCell> cells;
	std::visit(
	    [&]<class G>(const G& grid)
	    {
		    if constexpr (kIsLattice<G>)
			    forCellsAround(grid, cell.cell,
			                   [&](CellId near) {
				                   cells.push_back(farCellOf(grid, vectors, borders, {cell.block, near}));
			                   });
	    },
	    blocks.blocks[cell.block].grid);
	return cells;
}

} // namespace vp::vectors
