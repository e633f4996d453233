#include "same_mesh.h"
#include "sliced_sheet.h"
#include "test_grids.h"
#include "tries.h"

#include "grid/demo/demo.h"
#include "measure/components.h"
#include "seed/row_seeds.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

/// A block whose grid is curvilinear, finished for one cut, and its seams not looked for.
grid::BlockSet forOneCut(const grid::Block& block)
{
	grid::BlockSet set;
	grid::Block& made = set.blocks.emplace_back();
	made.name = block.name;
	made.grid = block.grid;
	addTestFields(made);
	finishBlock(made, true);
	set.matches_seams = false;
	return set;
}

} // namespace

// The grids of allGrids() have their axes turned already, so cells have the same numbers.
TEST(OneCut, FindsWhatATraversalFindsInCurvilinearGrids)
{
	std::size_t grids = 0;
	for (const grid::Block& block : allGrids())
	{
		if (!std::holds_alternative<grid::CurvilinearGrid>(block.grid))
			continue;
		++grids;
		SCOPED_TRACE(block.name);
		grid::BlockSet whole = setOf(block);
		grid::matchInterfaces(whole);
		const grid::BlockSet once = forOneCut(block);
		EXPECT_FALSE(once.blocks[0].knows_folds);
		EXPECT_TRUE(once.blocks[0].inverted.empty());
		cut::Cutter searcher(whole);
		cut::Cutter cutter(once);
		std::vector<TestPlane> planes = randomPlanes(block.bounds, tries(30), 91);
		for (const TestPlane& plane : degeneratePlanes(block, 92))
			planes.push_back(plane);
		for (const TestPlane& plane : planes)
		{
			const SlicedSheet expected = cut(searcher, plane);
			const SlicedSheet found = cut(cutter, plane, {}, Search::fastest);
			EXPECT_EQ(found.cutCells(), expected.cutCells());
			expectSameMesh(found.mesh, expected.mesh);
			EXPECT_EQ(measure::countComponents(found.mesh), measure::countComponents(expected.mesh));
		}
		if (HasFailure())
			return;
	}
	EXPECT_GE(grids, 3u);
}

// Rows longer than a word of 64 bits, and exactly as long.
TEST(OneCut, ASeedForEveryRun)
{
	Taken taken;
	for (const int n : {64, 63, 65, 130})
	{
		if (!taken.next())
			continue;
		const grid::BlockSet set = std::move(*grid::makeDemo("shell", n));
		const auto& grid = std::get<grid::CurvilinearGrid>(set.blocks[0].grid);
		const TestPlane asked{set.bounds().center(), {0.3, 0.5, 0.81}};
		const std::vector<CellId> seeds = seed::rowSeeds(grid, probe::makeSheet(asked.origin, asked.normal).plane());
		std::vector<CellId> firsts;
		CellId last = kNoCell;
		for (const CellId cell : scanCutCells(set.blocks[0], asked))
		{
			if (cell == 0 || last != cell - 1 || cell % grid.cells()[0] == 0)
				firsts.push_back(cell);
			last = cell;
		}
		EXPECT_EQ(seeds, firsts) << n;
	}
}

} // namespace vp::test
