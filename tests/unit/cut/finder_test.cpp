#include "random_window.h"
#include "same_mesh.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"
#include "test_grids.h"

#include "grid/demo/demo.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

// Compares what the fastest strategy finds with the traversal.
std::size_t compareFinders(const grid::BlockSet& set, const TestPlane& plane, const seed::SeedOptions& seeds = {},
                           const std::optional<probe::Window>& window = std::nullopt)
{
	cut::Cutter cutter(set);
	const SlicedSheet expected = cut(cutter, plane, seeds, Search::generations, window);
	const SlicedSheet found = cut(cutter, plane, seeds, Search::fastest, window);
	std::size_t in_spans = 0;
	for (std::size_t b = 0; b < set.blocks.size(); ++b)
	{
		EXPECT_EQ(found.cutCells(b), expected.cutCells(b));
		EXPECT_EQ(found.slice.cuts[b].cutCells(), expected.slice.cuts[b].cutCells());
		in_spans += found.slice.cuts[b].hasSpans();
	}
	expectSameMesh(found.mesh, expected.mesh);
	return in_spans;
}

TEST(Finder, TheFastestFindsWhatTheTraversalFinds)
{
	std::size_t in_spans = 0;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet set = setOf(block);
		for (const TestPlane& plane : randomPlanes(block.bounds, 40, 7))
			in_spans += compareFinders(set, plane);
		for (const TestPlane& plane : degeneratePlanes(block, 8))
			in_spans += compareFinders(set, plane);
		if (HasFailure())
			return;
	}
	EXPECT_GT(in_spans, 200u);
}

// A generation of one block may reach across a seam into a block whose cells are found in another way.
TEST(Finder, GenerationsBesideABlockOfSpans)
{
	const Array<double> up(std::vector{0.0, 0.25, 0.5, 0.75, 1.0});
	grid::Block folded;
	folded.name = "folded";
	folded.grid = grid::RectilinearGrid(Array<double>(std::vector{1.0, 1.5, 1.25, 2.0}), up, up);
	grid::finishBlock(folded);
	const grid::BlockSet set = setOfBlocks({latticeBlock(straight, 0.0, false), std::move(folded)});
	ASSERT_GT(set.interfaces.seam_faces, 0u);
	std::size_t in_spans = 0;
	for (const TestPlane& plane : randomPlanes(set.bounds(), 40, 17))
		in_spans += compareFinders(set, plane);
	EXPECT_EQ(in_spans, 40u);
}

TEST(Finder, Windows)
{
	std::mt19937 random(13);
	std::size_t in_spans = 0;
	const auto compare = [&](const grid::BlockSet& set, const TestPlane& plane)
	{
		const probe::Window window = randomWindow(set.bounds(), random);
		in_spans += compareFinders(set, plane, {}, window);
	};
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet set = setOf(block);
		for (const TestPlane& plane : randomPlanes(block.bounds, 80, 14))
			compare(set, plane);
		for (const TestPlane& plane : degeneratePlanes(block, 15))
			compare(set, plane);
		if (HasFailure())
			return;
	}
	const grid::BlockSet fine = std::move(*grid::makeDemo("shell", 37)); // with cells far within windows
	for (const TestPlane& plane : randomPlanes(fine.bounds(), 100, 16))
		compare(fine, plane);
	EXPECT_GT(in_spans, 400u);
}

// The queue searched in place of marks: the same cells in the same generations.
TEST(Finder, OctantsOfTheQueueKnowWhatStampsKnow)
{
	std::mt19937 random(17);
	std::size_t generations = 0;
	const auto compare =
	    [&](const grid::BlockSet& set, const TestPlane& plane, const std::optional<probe::Window>& window)
	{
		cut::Cutter cutter(set);
		cut::CutRequest request;
		request.in_generations = true;
		request.probe.sheets = {probe::makeSheet(plane.origin, plane.normal)};
		request.probe.sheets[0].window = window;
		const cut::Cut stamps = std::move(cutter.cut(request).value());
		request.visited = find::VisitedSet::octants;
		const cut::Cut octants = std::move(cutter.cut(request).value());
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
		{
			const find::CellCut& expected = stamps.sheets[0].cuts[b].cells();
			const find::CellCut& found = octants.sheets[0].cuts[b].cells();
			ASSERT_EQ(found.cells, expected.cells);
			ASSERT_EQ(found.generation_starts, expected.generation_starts);
			generations = std::max(generations, found.generations());
		}
	};
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		const grid::BlockSet set = setOf(block);
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 18))
			compare(set, plane, std::nullopt);
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 19))
			compare(set, plane, randomWindow(set.bounds(), random));
	}
	const grid::BlockSet seamed = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)});
	for (const TestPlane& plane : randomPlanes(seamed.bounds(), 20, 20))
		compare(seamed, plane, std::nullopt);
	EXPECT_GT(generations, 4u);
}

TEST(Finder, OnePieceFromTheHotSpotAlone)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	std::size_t in_spans = 0; // a plane that misses the grid has none
	for (const TestPlane& plane : randomPlanes(set.bounds(), 40, 9))
		in_spans += compareFinders(set, plane, {.mode = seed::SeedMode::hotspot});
	EXPECT_GT(in_spans, 20u);
}

// Long rows, so that runs pass the end of what is looked at in one step.
TEST(Finder, LongRuns)
{
	const grid::BlockSet set = std::move(*grid::makeDemo("shell", 37));
	for (const TestPlane& plane : randomPlanes(set.bounds(), 30, 10))
		EXPECT_EQ(compareFinders(set, plane), 1u);
	for (const TestPlane& plane : degeneratePlanes(set.blocks[0], 11))
		EXPECT_EQ(compareFinders(set, plane), 1u);
}

TEST(Finder, TheSameMeshForAnyNumberOfThreads)
{
	const grid::BlockSet set = std::move(*grid::makeDemo("shell", 96));
	cut::Cutter cutter(set);
	for (const TestPlane& plane : randomPlanes(set.bounds(), 6, 12))
	{
		std::vector<mesh::SheetMesh> meshes;
		for (const int threads : {1, 2, 4})
		{
			const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
			meshes.push_back(cut(cutter, plane, {}, Search::fastest).mesh);
		}
		for (const mesh::SheetMesh& mesh : meshes)
		{
			EXPECT_TRUE(mesh.positions == meshes[0].positions);
			EXPECT_TRUE(mesh.polygon_vertices == meshes[0].polygon_vertices);
			EXPECT_TRUE(mesh.polygon_starts == meshes[0].polygon_starts);
		}
	}
}

} // namespace

} // namespace vp::test
