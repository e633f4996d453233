#include "test_grids.h"

#include "grid/link/middle_part.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace vp::test
{

namespace
{

using PlaceSet = std::multiset<std::array<double, 3>>;

// A cell by the places of its points.
template <class G>
PlaceSet cornersOf(const G& grid, CellId cell)
{
	PlaceSet corners;
	for (const PointId p : grid.cellPoints(cell))
		corners.insert({grid.point(p).x, grid.point(p).y, grid.point(p).z});
	return corners;
}

std::multiset<PlaceSet> tableCells(const grid::AnyGrid& any)
{
	std::multiset<PlaceSet> cells;
	std::visit(
	    [&](const auto& grid)
	    {
		    for (CellId cell = 0; cell < grid.cellCount(); ++cell)
			    if (grid.shape(cell) != grid::CellShape::polyhedron)
				    cells.insert(cornersOf(grid, cell));
	    },
	    any);
	return cells;
}

} // namespace

TEST(MiddlePart, HoldsCellsOfTheBlock)
{
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const std::multiset<PlaceSet> all = tableCells(block.grid);
		for (const std::size_t side : {1u, 3u, 100u})
		{
			const grid::Block part = grid::middlePart(block, side);
			grid::validate(part);
			const std::multiset<PlaceSet> cells = tableCells(part.grid);
			EXPECT_LE(cells.size(), side * side * side);
			EXPECT_TRUE(std::ranges::includes(all, cells));
			EXPECT_TRUE(side < 100 || cells.size() == all.size());
		}
	}
}

TEST(MiddlePart, LiesInTheMiddle)
{
	grid::Block block;
	block.grid = grid::UniformGrid({8, 5, 2}, Vec3(0.0), Vec3(1.0));
	grid::finishBlock(block);
	const grid::Block part = grid::middlePart(block, 3);
	EXPECT_EQ(part.bounds.lo, Vec3(2.0, 0.0, 0.0));
	EXPECT_EQ(part.bounds.hi, Vec3(5.0, 3.0, 1.0));
	const auto& grid = std::get<grid::UnstructuredGrid>(part.grid);
	EXPECT_FALSE(grid.coordinates().isDouble());
	EXPECT_EQ(grid.pointCount(), 4u * 4 * 2);
}

} // namespace vp::test
