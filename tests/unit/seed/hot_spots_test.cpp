#include "random_window.h"
#include "same_mesh.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include "grid/demo/demo.h"
#include "seed/hot_spots.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vp::test
{

namespace
{

constexpr seed::SeedOptions kLattice{.lattice = true};

// A sheet through a set of one block, with the cells that its hot spots add.
struct SpreadSheet
{
	SpreadSheet(const grid::BlockSet& set, const TestPlane& plane, const std::optional<probe::Window>& window)
	    : sheet(probe::makeSheet(plane.origin, plane.normal))
	{
		sheet.window = window;
		seeds = seed::findSeeds(set, sheet, kLattice);
		spots = seed::spreadHotSpots(set.blocks[0], sheet, seeds.rim[0], seeds.cells[0]);
	}

	probe::Sheet sheet;
	seed::SheetSeeds seeds;
	seed::HotSpots spots;
};

std::optional<probe::Window> maybeWindow(const Box& bounds, std::mt19937& random)
{
	return random() % 2 ? std::optional(randomWindow(bounds, random)) : std::nullopt;
}

TEST(HotSpots, AreCutCells)
{
	std::mt19937 random(91);
	std::size_t spots = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet set = setOf(block);
		std::vector<TestPlane> planes = randomPlanes(block.bounds, 30, 92);
		for (const TestPlane& plane : degeneratePlanes(block, 93))
			planes.push_back(plane);
		for (const TestPlane& plane : planes)
		{
			const SpreadSheet spread(set, plane, maybeWindow(block.bounds, random));
			spots += spread.spots.cells.size();
			for (const CellId cell : spread.spots.cells)
				ASSERT_TRUE(isCut(block, cell, Side(plane)));
		}
	}
	EXPECT_GT(spots, 1000u);
}

TEST(HotSpots, ChangeNothingButTheGenerations)
{
	std::mt19937 random(94);
	std::size_t cells = 0;
	const auto compare = [&](const grid::BlockSet& set, const TestPlane& plane)
	{
		const std::optional<probe::Window> window = maybeWindow(set.bounds(), random);
		cut::Cutter cutter(set);
		const SlicedSheet expected = cut(cutter, plane, {}, Search::generations, window);
		const SlicedSheet found = cut(cutter, plane, kLattice, Search::generations, window);
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
		{
			ASSERT_EQ(found.cutCells(b), expected.cutCells(b));
			EXPECT_EQ(found.slice.cuts[b].cells().cut_cells, expected.slice.cuts[b].cells().cut_cells);
			cells += found.slice.cuts[b].cutCells();
		}
		expectSameMesh(found.mesh, expected.mesh);
	};
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 95))
			compare(setOf(block), plane);
		for (const TestPlane& plane : degeneratePlanes(block, 96))
			compare(setOf(block), plane);
	}
	const grid::BlockSet seamed = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)});
	for (const TestPlane& plane : randomPlanes(seamed.bounds(), 20, 97))
		compare(seamed, plane);
	EXPECT_GT(cells, 10000u);
}

// The aim is 24 for a first cut; these grids stay below however large they are.
TEST(HotSpots, LeaveFewGenerations)
{
	std::mt19937 random(98);
	for (const auto& [name, n] : {std::pair("shell", 96), std::pair("hexes", 64), std::pair("tets", 40)})
	{
		const grid::BlockSet set = std::move(*grid::makeDemo(name, n));
		cut::Cutter cutter(set);
		std::size_t most = 0;
		std::size_t most_without = 0;
		const auto see = [&](const TestPlane& plane, const std::optional<probe::Window>& window)
		{
			const SlicedSheet spread = cut(cutter, plane, kLattice, Search::generations, window);
			const SlicedSheet without = cut(cutter, plane, {}, Search::generations, window);
			most = std::max(most, spread.slice.cuts[0].cells().generations());
			most_without = std::max(most_without, without.slice.cuts[0].cells().generations());
			EXPECT_LE(spread.slice.seeds.hops,
			          0.2 * static_cast<double>(spread.cutCellCount()) + 6.0 * std::cbrt(set.cellCount()));
		};
		for (const TestPlane& plane : randomPlanes(set.bounds(), 20, 99))
		{
			see(plane, std::nullopt);
			see(plane, randomWindow(set.bounds(), random));
		}
		EXPECT_LE(most, 24u) << name;
		EXPECT_GT(most_without, 30u) << name;
	}
}

TEST(HotSpots, AreTheSameForAnyNumberOfThreads)
{
	const grid::BlockSet set = std::move(*grid::makeDemo("shell", 64));
	for (const TestPlane& plane : randomPlanes(set.bounds(), 6, 100))
	{
		std::vector<std::vector<CellId>> found;
		for (const int threads : {1, 2, 4})
		{
			const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
			found.push_back(SpreadSheet(set, plane, std::nullopt).spots.cells);
		}
		EXPECT_EQ(found[1], found[0]);
		EXPECT_EQ(found[2], found[0]);
	}
}

// The cells of the previous cut seed the next one if it has moved by less than a cell.
TEST(HotSpots, OfTheCutBefore)
{
	const grid::BlockSet set = std::move(*grid::makeDemo("shell", 64));
	cut::Cutter cutter(set);
	const auto cutAt = [&](const TestPlane& plane, const cut::Cut* last)
	{
		cut::CutRequest request;
		request.in_generations = true;
		request.seeds = kLattice;
		request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
		if (last)
			request.last = std::make_shared<cut::Cut>(*last);
		return std::move(*cutter.cut(request));
	};
	const auto cellsOf = [&](const cut::Cut& slice) { return SlicedSheet{&set, slice.sheets[0], {}}.cutCells(); };
	std::size_t kept = 0;
	for (const TestPlane& plane : randomPlanes(set.bounds(), 20, 101))
	{
		const cut::Cut first = cutAt(plane, nullptr);
		for (const double moved : {1e-5, 0.002, 0.01, 0.3})
		{
			const TestPlane there{plane.origin + moved * glm::normalize(plane.normal), plane.normal};
			const cut::Cut next = cutAt(there, &first);
			const cut::Cut alone = cutAt(there, nullptr);
			EXPECT_EQ(cellsOf(next), cellsOf(alone));
			EXPECT_NE(next.sheets[0].number, first.sheets[0].number);
			const find::CellCut& cut = next.sheets[0].cuts[0].cells();
			EXPECT_LE(cut.cells.size(), 1.25 * cut.cut_cells + 30);
			if (moved == 1e-5 && cut.cut_cells > 200)
			{
				EXPECT_LE(cut.generations(), 3u);
				EXPECT_LE(next.sheets[0].seeds.hops, alone.sheets[0].seeds.hops);
				++kept;
			}
		}
	}
	EXPECT_GT(kept, 10u);
}

} // namespace

} // namespace vp::test
