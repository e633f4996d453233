#include "sliced_sheet.h"
#include "test_grids.h"

#include "base/timeline.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <thread>

namespace vp::test
{

namespace
{

cut::CutRequest requestOf(const std::vector<TestPlane>& planes)
{
	cut::CutRequest request;
	request.in_generations = true;
	for (const TestPlane& plane : planes)
		request.probe.sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
	return request;
}

std::vector<CellId> cellsOf(const find::CellCut& cut)
{
	return sorted(cut.cells);
}

} // namespace

TEST(Cutter, SheetsOfOneProbeAreCutAsIfAlone)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	const std::vector<TestPlane> planes = randomPlanes(set.bounds(), 6, 60);
	const cut::Cut together = std::move(cutter.cut(requestOf(planes)).value());
	ASSERT_EQ(together.sheets.size(), planes.size());
	for (std::size_t s = 0; s < planes.size(); ++s)
	{
		const cut::Cut alone = std::move(cutter.cut(requestOf({planes[s]})).value());
		EXPECT_EQ(together.sheets[s].cuts[0].cells().cells, alone.sheets[0].cuts[0].cells().cells);
		EXPECT_EQ(together.sheets[s].cuts[0].cells().codes, alone.sheets[0].cuts[0].cells().codes);
		EXPECT_EQ(together.mesh(set, s).positions, alone.mesh(set, 0).positions);
	}
}

TEST(Cutter, SeveralSlicesMayBeUnderWay)
{
	const grid::BlockSet set = setOf(gridNamed("tets"));
	cut::Cutter cutter(set);
	const std::vector<TestPlane> planes = randomPlanes(set.bounds(), 12, 61);
	std::vector<cut::CutTicket> tickets;
	for (const TestPlane& plane : planes)
		tickets.push_back(cutter.begin(requestOf({plane, planes[0]})));
	for (std::size_t i = planes.size(); i-- > 0;)
	{
		const cut::Cut slice = std::move(tickets[i].wait().value());
		EXPECT_EQ(cellsOf(slice.sheets[0].cuts[0].cells()), scanCutCells(set.blocks[0], planes[i]));
		EXPECT_EQ(cellsOf(slice.sheets[1].cuts[0].cells()), scanCutCells(set.blocks[0], planes[0]));
	}
}

TEST(Cutter, ManyThreadsMayAskAtOnce)
{
	const grid::BlockSet set = setOf(gridNamed("mixed"));
	cut::Cutter cutter(set);
	std::vector<std::thread> threads;
	for (unsigned t = 0; t < 4; ++t)
		threads.emplace_back(
		    [&, t]
		    {
			    for (const TestPlane& plane : randomPlanes(set.bounds(), 20, 62 + t))
				    EXPECT_EQ(cut(cutter, plane).cutCells(), scanCutCells(set.blocks[0], plane));
		    });
	for (std::thread& thread : threads)
		thread.join();
}

TEST(Cutter, ACancelledTicketEndsCleanly)
{
	const grid::BlockSet set = setOf(gridNamed("hexes"));
	cut::Cutter cutter(set);
	const std::vector<TestPlane> planes = randomPlanes(set.bounds(), 20, 66);
	for (int i = 0; i < 20; ++i)
	{
		cut::CutTicket dropped = cutter.begin(requestOf(planes));
		cut::CutTicket cancelled = cutter.begin(requestOf(planes));
		cancelled.cancel();
		const Result<cut::Cut> slice = cancelled.wait();
		ASSERT_TRUE(slice);
		for (std::size_t s = 0; s < planes.size();
		     ++s) // what was found until then is right, and a mesh can be made of it
		{
			for (const CellId cell : cellsOf(slice->sheets[s].cuts[0].cells()))
				EXPECT_TRUE(isCut(set.blocks[0], cell, Side(planes[s])));
			EXPECT_LE(slice->mesh(set, s).polygons(), slice->sheets[s].cuts[0].cells().cells.size());
		}
	}
}

TEST(Cutter, BlocksAreCutEachForItself)
{
	grid::BlockSet set;
	set.blocks = {gridNamed("blob"), gridNamed("u_shape"), gridNamed("two_pieces")};
	cut::Cutter cutter(set);
	for (const TestPlane& plane : randomPlanes(set.blocks[1].bounds, 20, 67))
	{
		const SlicedSheet sheet = cut(cutter, plane);
		ASSERT_EQ(sheet.slice.cuts.size(), 3u);
		for (std::size_t b = 0; b < 3; ++b)
			EXPECT_EQ(sheet.cutCells(b), scanCutCells(set.blocks[b], plane));
	}
}

TEST(Cutter, PiecesAreCounted)
{
	const grid::BlockSet pieces = setOf(gridNamed("two_pieces"));
	cut::Cutter cutter(pieces);
	const auto components = [&](const seed::SeedOptions& seeds) {
		return measure::measure(pieces, cut(cutter, {{0.1, 0.45, 0.45}, {0.0, 0.3, 1.0}}, seeds).mesh, {}).components;
	};
	EXPECT_EQ(components({}), 2u);
	EXPECT_EQ(components({seed::SeedMode::hotspot, seed::OutsidePolicy::nearest}), 1u);

	const grid::BlockSet u = setOf(gridNamed("u_shape"));
	cut::Cutter u_cutter(u);
	const auto at = [&](double y) {
		return measure::measure(u, cut(u_cutter, {{0.5, y, 0.5}, {0.0, 1.0, 0.0}}).mesh, {}).components;
	};
	EXPECT_EQ(at(0.1), 1u);
	EXPECT_EQ(at(0.8), 2u);
	EXPECT_EQ(at(1.1), 0u);
}

TEST(Cutter, TellsWhereTheTimeWent)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	Timeline timeline;
	cut::CutRequest request = requestOf({{set.bounds().center(), {0.0, 0.0, 1.0}}});
	request.timeline = &timeline;
	ASSERT_TRUE(cutter.cut(request));
	EXPECT_GT(timeline.total("seed"), 0.0);
	EXPECT_GT(timeline.total("traverse"), 0.0);
}

TEST(Cutter, AnEmptyCutIsASliceToo)
{
	for (const grid::Block& block : allGrids())
	{
		const grid::BlockSet set = setOf(block);
		cut::Cutter cutter(set);
		const SlicedSheet sheet = cut(cutter, {block.bounds.hi + block.bounds.size(), {1.0, 1.0, 1.0}});
		EXPECT_EQ(sheet.touched(), 0u);
		EXPECT_EQ(sheet.mesh.polygons(), 0u);
		EXPECT_EQ(sheet.mesh.polygon_starts.size(), 1u);
	}
}

// The witness floods from the seeds through cut cells that have a part in the range.
TEST(Cutter, AThresholdEndsTheTraversal)
{
	for (const char* name : {"shell", "mixed"})
	{
		const grid::BlockSet set = setOf(gridNamed(name));
		const grid::Block& block = set.blocks[0];
		cut::Cutter cutter(set);
		const auto [lo, hi] = grid::fieldRange(set, {"linear"});
		const find::Threshold threshold{lo + 0.4 * (hi - lo), lo + 0.5 * (hi - lo)};
		const auto within = [&](CellId cell)
		{
			double least = std::numeric_limits<double>::infinity();
			double most = -least;
			for (const Vec3& corner : cellCorners(block, cell))
			{
				least = std::min(least, linearAt(corner));
				most = std::max(most, linearAt(corner));
			}
			return least <= threshold.hi && most >= threshold.lo;
		};
		std::size_t ended = 0;
		for (const TestPlane& plane : randomPlanes(set.bounds(), 20, 62))
		{
			cut::CutRequest request = requestOf({plane});
			request.field = grid::FieldChoice{"linear"};
			request.threshold = threshold;
			const cut::Cut slice = std::move(cutter.cut(std::move(request)).value());

			std::set<CellId> reached;
			std::vector<CellId> queue;
			const auto enter = [&](CellId cell)
			{
				if (isCut(block, cell, Side(plane)) && within(cell) && reached.insert(cell).second)
					queue.push_back(cell);
			};
			for (const CellId seed : slice.sheets[0].seeds.cells[0])
				enter(seed);
			for (std::size_t i = 0; i < queue.size(); ++i)
				for (const CellId neighbor : cutNeighbors(block, queue[i], Side(plane)))
					enter(neighbor);
			EXPECT_EQ(cellsOf(slice.sheets[0].cuts[0].cells()), std::vector(reached.begin(), reached.end())) << name;
			ended += !reached.empty() && reached.size() < scanCutCells(block, plane).size();
		}
		EXPECT_GT(ended, 5u) << name;
	}
}

TEST(Cutter, AThresholdOverWhatABlockLacksShowsNothing)
{
	const grid::BlockSet set = setOf(gridNamed("shell"));
	cut::Cutter cutter(set);
	cut::CutRequest request = requestOf({{set.bounds().center(), {0.1, 0.2, 1.0}}});
	request.field = grid::FieldChoice{"missing"};
	request.threshold = find::Threshold{-1e30, 1e30};
	EXPECT_TRUE(cutter.cut(std::move(request)).value().sheets[0].cuts[0].cells().cells.empty());
}

} // namespace vp::test
