#include "exhaustive.h"
#include "test_grids.h"

#include "find/generations.h"
#include "seed/seeds.h"
#include "surface/plane.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace vp::test
{

namespace
{

using PlaneInBlock = find::SheetInBlock<surface::Plane>;

// Words from an exhaustive point of view: it knows no case table and leaves every cell to the walk.
struct WalkEverything
{
	std::size_t calls = 0;
	std::size_t stop_at = 0;
	std::stop_source stop;

	Status classify(std::span<const find::Front> fronts)
	{
		for (const find::Front& front : fronts)
			std::ranges::fill(front.codes, shared::kCodeWalk);
		if (++calls == stop_at)
			stop.request_stop();
		return Nothing{};
	}
};

// By the table, as the CPU classifier has it.
struct ByTable
{
	std::span<const PlaneInBlock> sheets;

	Status classify(std::span<const find::Front> fronts)
	{
		for (const find::Front& front : fronts)
			std::visit(
			    [&](const auto& grid)
			    {
				    grid::CellFaces faces;
				    for (std::size_t i = 0; i < front.cells.size(); ++i)
				    {
					    const grid::CellShape shape = grid.shape(front.cells[i]);
					    front.codes[i] =
					        shape == grid::CellShape::polyhedron
					            ? shared::kCodeWalk
					            : find::classifyByTable(grid, sheets[front.sheet].surface, front.cells[i], shape);
				    }
			    },
			    sheets[front.sheet].block->grid);
		return Nothing{};
	}
};

struct Fails
{
	Status classify(std::span<const find::Front>) { return Error{ErrorKind::device, "device lost"}; }
};

std::vector<CellId> seedsOf(const grid::Block& block, const TestPlane& plane)
{
	grid::BlockSet set;
	set.blocks.push_back(block);
	return seed::findSeeds(set, probe::makeSheet(plane.origin, plane.normal), {}).cells[0];
}

find::CellCut traverseAlone(const grid::Block& block, const TestPlane& plane, find::VisitedMarks& marks,
                            std::vector<CellId> seeds)
{
	marks.beginCut();
	std::vector<PlaneInBlock> sheets{{&block, surface::Plane(plane.origin, plane.normal), &marks, std::move(seeds)}};
	ByTable classifier{sheets};
	return std::move(find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier).value()[0]);
}

std::vector<CellId> cutCells(const find::CellCut& cut)
{
	std::vector<CellId> cells;
	for (std::size_t i = 0; i < cut.cells.size(); ++i)
		if (cut.codes[i] & shared::kCodeCut)
			cells.push_back(cut.cells[i]);
	return sorted(std::move(cells));
}

} // namespace

TEST(BreadthFirst, GenerationsAreDistancesFromTheSeeds)
{
	for (const grid::Block& block : allGrids())
	{
		find::VisitedMarks marks(cellCount(block));
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 70))
		{
			const Side side(plane);
			std::vector<CellId> seeds = seedsOf(block, plane);
			if (seeds.size() > 3)
				seeds.resize(3); // few, so that there are generations
			const find::CellCut cut = traverseAlone(block, plane, marks, seeds);

			std::map<CellId, std::size_t> distance;
			std::vector<CellId> queue;
			for (const CellId seed : seeds)
				if (distance.emplace(seed, 0).second)
					queue.push_back(seed);
			for (std::size_t i = 0; i < queue.size(); ++i)
				if (isCut(block, queue[i], side))
					for (const CellId next : cutNeighbors(block, queue[i], side))
						if (distance.emplace(next, distance[queue[i]] + 1).second)
							queue.push_back(next);

			ASSERT_EQ(cut.cells.size(), distance.size()) << block.name;
			ASSERT_EQ(cut.codes.size(), cut.cells.size());
			ASSERT_EQ(cut.generation_starts.back(), cut.cells.size());
			ASSERT_EQ(std::set<CellId>(cut.cells.begin(), cut.cells.end()).size(), cut.cells.size())
			    << "a cell queued twice";
			std::size_t widest = 0;
			for (std::size_t g = 0; g < cut.generations(); ++g)
			{
				ASSERT_LT(cut.generation_starts[g], cut.generation_starts[g + 1]) << "an empty generation";
				widest = std::max<std::size_t>(widest, cut.generation_starts[g + 1] - cut.generation_starts[g]);
				for (std::size_t i = cut.generation_starts[g]; i < cut.generation_starts[g + 1]; ++i)
					ASSERT_EQ(distance[cut.cells[i]], g) << block.name;
			}
			EXPECT_EQ(cut.frontMax(), widest);
			EXPECT_EQ(cut.cut_cells, cutCells(cut).size());
		}
	}
}

TEST(BreadthFirst, TouchesOnlyWhatIsCut)
{
	for (const grid::Block& block : allGrids())
	{
		find::VisitedMarks marks(cellCount(block));
		for (const TestPlane& plane : randomPlanes(block.bounds, 20, 71))
		{
			// Across a cut face lies a cut cell, except where cells do not share the face's points.
			const find::CellCut cut = traverseAlone(block, plane, marks, scanCutCells(block, plane));
			EXPECT_EQ(cutCells(cut), scanCutCells(block, plane)) << block.name;
			if (block.name != "two_to_one")
			{
				EXPECT_EQ(cut.cells.size(), cut.cut_cells) << block.name;
			}
		}
	}
}

TEST(BreadthFirst, MarksWrapAroundUnnoticed)
{
	const grid::Block& block = gridNamed("shell");
	const std::vector<TestPlane> planes = randomPlanes(block.bounds, 5, 72);
	find::VisitedPool pool(cellCount(block));
	std::vector<std::vector<CellId>> expected;
	std::vector<std::vector<CellId>> seeds;
	for (const TestPlane& plane : planes)
	{
		expected.push_back(scanCutCells(block, plane));
		seeds.push_back(seedsOf(block, plane));
	}
	for (std::size_t slice = 0; slice < 650; ++slice)
	{
		std::vector<find::VisitedPool::Loan> loans;
		std::vector<PlaneInBlock> sheets;
		for (std::size_t sheet = 0; sheet < 1 + slice % 3;
		     ++sheet) // sheets come and go, so marks are not at the same number
		{
			const std::size_t p = (slice + sheet) % planes.size();
			loans.push_back(pool.borrow());
			sheets.push_back(
			    {&block, surface::Plane(planes[p].origin, planes[p].normal), loans.back().get(), seeds[p]});
		}
		ByTable classifier{sheets};
		const auto cuts = find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier);
		ASSERT_TRUE(cuts);
		for (std::size_t sheet = 0; sheet < sheets.size(); ++sheet)
			ASSERT_EQ(sorted((*cuts)[sheet].cells), expected[(slice + sheet) % planes.size()]) << "slice " << slice;
	}
}

// A sheet that comes back after one lap of the slice number meets its own stamps where no other sheet has been since.
TEST(BreadthFirst, StampsOfTheLastLapAreForgotten)
{
	const grid::Block& block = gridNamed("shell");
	const std::vector<TestPlane> planes = randomPlanes(block.bounds, 2, 74);
	find::VisitedMarks marks(cellCount(block));
	for (int slice = 0; slice < 600; ++slice)
	{
		const TestPlane& plane = planes[slice % 255 == 0 ? 0 : 1];
		const find::CellCut cut = traverseAlone(block, plane, marks, seedsOf(block, plane));
		ASSERT_EQ(sorted(cut.cells), scanCutCells(block, plane)) << "slice " << slice;
	}
}

TEST(BreadthFirst, SheetsInLockStepDoNotDisturbEachOther)
{
	for (const grid::Block& block : allGrids())
	{
		const Vec3 center = block.bounds.center();
		const std::vector<TestPlane> planes{
		    {center, {1.0, 0.1, 0.2}}, {center, {0.3, 1.0, 0.1}}, {center, {0.2, 0.3, 1.0}}};
		std::vector<std::unique_ptr<find::VisitedMarks>> marks;
		std::vector<PlaneInBlock> sheets;
		std::vector<find::CellCut> alone;
		for (const TestPlane& plane : planes)
		{
			marks.push_back(std::make_unique<find::VisitedMarks>(cellCount(block)));
			alone.push_back(traverseAlone(block, plane, *marks.back(), seedsOf(block, plane)));
			marks.back()->beginCut();
			sheets.push_back(
			    {&block, surface::Plane(plane.origin, plane.normal), marks.back().get(), seedsOf(block, plane)});
		}
		ByTable classifier{sheets};
		const auto together = find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier);
		ASSERT_TRUE(together);
		for (std::size_t sheet = 0; sheet < planes.size(); ++sheet)
		{
			EXPECT_EQ((*together)[sheet].cells, alone[sheet].cells) << block.name;
			EXPECT_EQ((*together)[sheet].codes, alone[sheet].codes) << block.name;
			EXPECT_EQ((*together)[sheet].generation_starts, alone[sheet].generation_starts) << block.name;
		}
	}
}

TEST(BreadthFirst, WalkingEveryCellFindsTheSame)
{
	for (const grid::Block& block : allGrids())
	{
		find::VisitedMarks marks(cellCount(block));
		for (const TestPlane& plane : randomPlanes(block.bounds, 10, 73))
		{
			const std::vector<CellId> seeds = seedsOf(block, plane);
			const find::CellCut expected = traverseAlone(block, plane, marks, seeds);
			marks.beginCut();
			std::vector<PlaneInBlock> sheets{{&block, surface::Plane(plane.origin, plane.normal), &marks, seeds}};
			WalkEverything classifier;
			const auto walked = find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier);
			ASSERT_TRUE(walked);
			EXPECT_EQ((*walked)[0].generation_starts, expected.generation_starts) << block.name;
			EXPECT_EQ(cutCells((*walked)[0]), cutCells(expected)) << block.name;
			EXPECT_EQ(classifier.calls, expected.generations());
		}
	}
}

TEST(BreadthFirst, SeedsThatAreNotCutDoNoHarm)
{
	const grid::Block& block = gridNamed("shell");
	const TestPlane plane{block.bounds.center(), {0.3, 0.5, 0.81}};
	std::vector<CellId> all(cellCount(block));
	for (CellId c = 0; c < all.size(); ++c)
		all[c] = c;
	all.insert(all.end(), {0, 5, 5});
	find::VisitedMarks marks(cellCount(block));
	const find::CellCut cut = traverseAlone(block, plane, marks, all);
	EXPECT_EQ(cut.cells.size(), cellCount(block));
	EXPECT_EQ(cutCells(cut), scanCutCells(block, plane));
	EXPECT_EQ(cut.generations(), 1u);
}

TEST(BreadthFirst, AStopEndsItBetweenGenerations)
{
	const grid::Block& block = gridNamed("shell");
	const TestPlane plane{block.bounds.center(), {0.3, 0.5, 0.81}};
	const std::vector<CellId> seeds{seedsOf(block, plane).front()};
	find::VisitedMarks marks(cellCount(block));
	const find::CellCut whole = traverseAlone(block, plane, marks, seeds);
	ASSERT_GT(whole.generations(), 5u);
	marks.beginCut();
	std::vector<PlaneInBlock> sheets{{&block, surface::Plane(plane.origin, plane.normal), &marks, seeds}};
	WalkEverything classifier;
	classifier.stop_at = 3;
	const auto stopped =
	    find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier, classifier.stop.get_token());
	ASSERT_TRUE(stopped);
	const find::CellCut& cut = (*stopped)[0];
	EXPECT_EQ(classifier.calls, 3u);
	EXPECT_EQ(cut.generations(), 3u);
	// Whatever uses the cut counts on a code for every cell.
	EXPECT_EQ(cut.codes.size(), cut.cells.size());
	EXPECT_EQ(cut.generation_starts.back(), cut.cells.size());
}

TEST(BreadthFirst, AClassifiersErrorComesBack)
{
	const grid::Block& block = gridNamed("blob");
	find::VisitedMarks marks(cellCount(block));
	marks.beginCut();
	std::vector<PlaneInBlock> sheets{{&block, surface::Plane(Vec3(0.0), Vec3(1.0)), &marks, {0}}};
	Fails classifier;
	const auto failed = find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier);
	ASSERT_FALSE(failed);
	EXPECT_EQ(failed.error().message, "device lost");
}

TEST(BreadthFirst, NoLanesAndNoSeeds)
{
	const grid::Block& block = gridNamed("blob");
	find::VisitedMarks marks(cellCount(block));
	marks.beginCut();
	WalkEverything classifier;
	std::vector<PlaneInBlock> sheets;
	EXPECT_TRUE(find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier)->empty());
	sheets.push_back({&block, surface::Plane(Vec3(0.0), Vec3(1.0)), &marks, {}});
	const auto cuts = find::breadthFirst<surface::Plane>(std::span<PlaneInBlock>(sheets), classifier);
	EXPECT_EQ((*cuts)[0].generations(), 0u);
	EXPECT_EQ((*cuts)[0].frontMax(), 0u);
	EXPECT_EQ(classifier.calls, 0u);
}

} // namespace vp::test
