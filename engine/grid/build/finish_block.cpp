#include "grid/block.h"
#include "grid/build/cell_bounds.h"
#include "grid/build/folds.h"
#include "grid/build/lattice_axes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace vp::grid
{

namespace
{

constexpr std::size_t kBoundaryVantages = 16;

// Of the points that are numbers.
template <Grid G>
Box boundsOf(const G& grid)
{
	return tbb::parallel_reduce(
	    tbb::blocked_range<std::size_t>(0, grid.usedPointCount(), 65536), Box{},
	    [&](const tbb::blocked_range<std::size_t>& range, Box box)
	    {
		    for (std::size_t p = range.begin(); p < range.end(); ++p)
		    {
			    const Vec3 x = grid.point(static_cast<PointId>(p));
			    if (std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z))
				    box.include(x);
		    }
		    return box;
	    },
	    [](Box a, const Box& b)
	    {
		    a.include(b);
		    return a;
	    });
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

void finishBlock(Block& block)
{
	replaceFields(block, std::move(block.fields));
	if (!hasNeighbors(block))
	{
		const auto& listed = std::get<UnstructuredGrid>(block.grid);
		block.bounds = boundsOfCells(listed.coordinates(), *listed.list());
		return;
	}
	if (auto* curvilinear = std::get_if<CurvilinearGrid>(&block.grid))
		*curvilinear = withShortestEdgesFirst(std::move(*curvilinear));
	std::visit(
	    [&](const auto& grid)
	    {
		    block.bounds = boundsOf(grid);
		    block.boundary = buildBoundaryIndex(grid);
		    block.vantage = distinct(vantagesOf(grid, block.boundary));
		    block.inverted = foldedCells(grid);
		    block.inverted_tree = BlockTree(grid, block.inverted);
		    block.tree = std::make_shared<LazyBlockTree>();
		    block.cell_places = std::make_shared<LazyCellPlaces>();
	    },
	    block.grid);
}

void buildNeighbors(BlockSet& blocks)
{
	if (hasNeighbors(blocks))
		return;
	for (Block& block : blocks.blocks)
	{
		if (hasNeighbors(block))
			continue;
		const auto& listed = std::get<UnstructuredGrid>(block.grid);
		block.grid = UnstructuredGrid::build(listed.coordinates(), *listed.list());
		finishBlock(block);
	}
	matchInterfaces(blocks);
}

} // namespace vp::grid
