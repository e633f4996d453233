#include "exhaustive.h"
#include "random_window.h"
#include "test_grids.h"

#include "find/cell_signs.h"
#include "seed/cut_cells.h"
#include "seed/sheet_window.h"

#include <gtest/gtest.h>

namespace vp::test
{

// What is not asked face by face would be told to meet the window, and most cells of a large window are not.
TEST(SheetWindow, HoldsOnlyCellsWhoseCutFacesMeetIt)
{
	std::mt19937 random(7);
	std::size_t held = 0;
	std::size_t cut = 0;
	for (const grid::Block& block : allGrids())
		for (const TestPlane& plane : randomPlanes(block.bounds, 40, 3))
		{
			SCOPED_TRACE(block.name);
			probe::Sheet sheet = probe::makeSheet(plane.origin, plane.normal);
			const double size = block.bounds.diagonal();
			sheet.window =
			    random() % 2 ? randomWindow(block.bounds, random) : probe::centeredWindow(0.6 * size, 0.4 * size);
			const seed::SheetWindow window(sheet);
			grid::CellFaces faces;
			const auto ask = [&](const auto& grid)
			{
				for (const CellId cell : scanCutCells(block, plane))
				{
					++cut;
					if (!window.holdsCell(grid, cell))
						continue;
					++held;
					grid.cellFaces(cell, faces);
					EXPECT_TRUE(window.meetsCell(grid, sheet.plane(), faces)) << cell;
					for (int f = 0; f < faces.size(); ++f)
						EXPECT_TRUE(!seed::isFaceCut(grid, sheet.plane(), faces[f]) ||
						            window.meetsFace(grid, sheet.plane(), faces[f]))
						    << cell;
				}
			};
			std::visit(ask, block.grid);
		}
	EXPECT_GT(held, cut / 10);
	EXPECT_LT(held, cut);
}

// It is the sheet's origin while the window holds that, its rim included.
TEST(SheetWindow, HasItsHotSpotWithin)
{
	const Vec3 origin(1.0, 2.0, 3.0);
	probe::Sheet sheet = probe::makeSheet(origin, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0});
	for (const probe::Window& window :
	     {probe::Window{-1.0, 1.0, -1.0, 1.0}, probe::Window{-1.0, 1.0, -2.0, 0.0}, probe::Window{-1.0, 1.0, 0.0, 2.0},
	      probe::Window{-2.0, 0.0, -1.0, 1.0}, probe::Window{0.0, 2.0, -1.0, 1.0}})
	{
		sheet.window = window;
		EXPECT_EQ(seed::SheetWindow(sheet).hotSpot(), origin) << window.x0 << ' ' << window.y0;
	}
	sheet.window = probe::Window{1.0, 3.0, 2.0, 6.0};
	EXPECT_EQ(seed::SheetWindow(sheet).hotSpot(), origin + Vec3(2.0, 4.0, 0.0));
}

TEST(SheetWindow, HoldsNoCellThatReachesOverItsRim)
{
	const grid::UniformGrid grid({5, 5, 2}, {0.0, 0.0, -0.5}, {1.0, 1.0, 1.0});
	probe::Sheet sheet = probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
	sheet.window = probe::Window{0.5, 3.25, 0.5, 2.75};
	const seed::SheetWindow window(sheet);
	for (CellId cell = 0; cell < grid.cellCount(); ++cell)
	{
		const auto [i, j, k] = grid.cellIndex(cell);
		EXPECT_EQ(window.holdsCell(grid, cell), i >= 1 && i + 1 <= 3 && j >= 1 && j + 1 <= 2) << i << ' ' << j;
	}
}

} // namespace vp::test
