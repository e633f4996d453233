#include "grid/block.h"
#include "grid/link/cell_bounds.h"
#include "grid/link/folds.h"
#include "grid/link/lattice_axes.h"

#include <algorithm>
#include <cmath>

namespace vp::grid
{

namespace
{

constexpr std::size_t kBoundaryVantages = 16;

// Returns the bounds of the finite points. For a lattice with straight axes, the coordinates along each axis are
// enough.
Box boundsOf(const UnstructuredGrid& grid)
{
	return boundsOfPoints(grid.coordinates(), grid.usedPointCount());
}
Box boundsOf(const CurvilinearGrid& grid)
{
	return boundsOfPoints(grid.coordinates(), grid.pointCount());
}
template <class G>
Box boundsOf(const G& grid)
{
	Box box;
	for (int axis = 0; axis < 3; ++axis)
		for (std::uint32_t i = 0; i < grid.points()[axis]; ++i)
			if (const double x = grid.coordinate(axis, i); std::isfinite(x))
			{
				box.lo[axis] = std::min(box.lo[axis], x);
				box.hi[axis] = std::max(box.hi[axis], x);
			}
	return box;
}

std::vector<CellId> vantagesOf(const Lattice& lattice, const BoundaryIndex&)
{
	std::vector<CellId> cells;
	if (lattice.cellCount() == 0)
		return cells;
	for (int f = 0; f < 6; ++f)
	{
		std::array<std::uint32_t, 3> at = lattice.cells();
		for (std::uint32_t& index : at)
			index /= 2;
		at[f / 2] = f % 2 ? lattice.cells()[f / 2] - 1 : 0;
		cells.push_back(lattice.cell(at[0], at[1], at[2]));
	}
	return cells;
}

std::vector<CellId> vantagesOf(const UnstructuredGrid& grid, const BoundaryIndex& boundary)
{
	std::vector<CellId> cells;
	if (grid.cellCount() == 0)
		return cells;
	// Faces lie along the Morton curve, so equal steps spread over the boundary.
	const std::size_t count = std::min(kBoundaryVantages, boundary.faces.size());
	for (std::size_t i = 0; i < count; ++i)
		cells.push_back(boundary.faces[(2 * i + 1) * boundary.faces.size() / (2 * count)].cell);
	cells.push_back(static_cast<CellId>(grid.cellCount() / 2));
	return cells;
}

std::vector<CellId> distinct(std::vector<CellId> cells)
{
	std::ranges::sort(cells);
	cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
	return cells;
}

} // namespace

void finishBlock(Block& block, bool for_one_cut)
{
	replaceFields(block, std::move(block.fields));
	if (!hasNeighbors(block))
	{
		const auto& listed = std::get<UnstructuredGrid>(block.grid);
		block.bounds = block.whole ? block.whole->bounds : boundsOfCells(listed.coordinates(), *listed.list());
		return;
	}
	auto* curvilinear = std::get_if<CurvilinearGrid>(&block.grid);
	block.knows_folds = !curvilinear || !for_one_cut;
	if (curvilinear && !for_one_cut)
		*curvilinear = withShortestEdgesFirst(std::move(*curvilinear));
	std::visit(
	    [&](const auto& grid)
	    {
		    block.bounds = block.whole ? block.whole->bounds : boundsOf(grid);
		    block.boundary = buildBoundaryIndex(grid);
		    block.vantage = distinct(vantagesOf(grid, block.boundary));
		    if (block.knows_folds)
			    block.inverted = foldedCells(grid);
		    block.inverted_tree = BlockTree(grid, block.inverted);
		    block.tree = std::make_shared<LazyBlockTree>();
		    block.cell_places = std::make_shared<LazyCellPlaces>();
	    },
	    block.grid);
}

Block linkedRuns(const Block& block, std::span<const std::uint32_t> runs)
{
	std::vector<CellId> cells;
	for (const std::uint32_t number : runs)
	{
		const CellRuns::Run& run = block.runs->runs()[number];
		for (std::uint32_t c = 0; c < run.cells; ++c)
			cells.push_back(static_cast<CellId>(run.first_cell + c));
	}
	Block part = block;
	part.grid = UnstructuredGrid::buildPart(std::get<UnstructuredGrid>(block.grid), cells);
	leaveFile(part);
	finishBlock(part);
	return part;
}

void buildNeighbors(BlockSet& blocks, bool for_one_cut)
{
	if (for_one_cut ? hasNeighbors(blocks) : isComplete(blocks))
		return;
	readAllParts(blocks);
	for (Block& block : blocks.blocks)
	{
		const bool is_listed = !hasNeighbors(block);
		if (is_listed)
		{
			const auto& listed = std::get<UnstructuredGrid>(block.grid);
			block.grid = UnstructuredGrid::build(listed.coordinates(), *listed.list());
		}
		if (is_listed || (!for_one_cut && !block.knows_folds))
			finishBlock(block);
	}
	matchInterfaces(blocks);
}

} // namespace vp::grid
