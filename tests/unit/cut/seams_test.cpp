#include "mesh/mesh_values.h"
#include "seamed_sets.h"
#include "sliced_sheet.h"

#include <gtest/gtest.h>

#include <set>

namespace vp::test
{

namespace
{

const seed::SeedOptions kHotSpot{seed::SeedMode::hotspot, seed::OutsidePolicy::report};

struct SeamedSet
{
	const char* name;
	grid::BlockSet set;
	grid::BlockSet whole; // the same domain in one piece
};

grid::Block withoutArrays(grid::Block block)
{
	block.fields.clear();
	return block;
}

std::vector<SeamedSet> seamedSets()
{
	const auto whole = [](Place place, bool closed = false)
	{ return setOfBlocks({hexahedraBlock(place, 0.0, 2.0, true, closed)}); };
	std::vector<SeamedSet> sets;
	sets.push_back(
	    {"turned", setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)}), whole(warped)});
	const grid::Block half = withoutArrays(hexahedraBlock(warped, 1.0, 2.0, true));
	sets.push_back({"hybrid", setOfBlocks({half, latticeBlock(warped, 0.0, true)}), whole(warped)});
	sets.push_back({"unmerged", setOfBlocks({hexahedraBlock(warped, 0.0, 2.0, false)}), whole(warped)});
	sets.push_back({"o_grid", setOfBlocks({oGrid()}), whole(ring, true)});
	sets.push_back({"unmerged_ring", setOfBlocks({hexahedraBlock(ring, 0.0, 2.0, false)}), whole(ring, true)});
	sets.push_back({"straight", setOfBlocks({latticeBlock(straight, 0.0, false), latticeBlock(straight, 1.0, true)}),
	                whole(straight)});
	return sets;
}

std::size_t scanCount(const grid::BlockSet& set, const TestPlane& plane)
{
	std::size_t count = 0;
	for (const grid::Block& block : set.blocks)
		count += scanCutCells(block, plane).size();
	return count;
}

} // namespace

TEST(Seams, OneSeedReachesThePieceItReachesInOneGrid)
{
	for (const SeamedSet& seamed : seamedSets())
	{
		cut::Cutter cutter(seamed.set);
		cut::Cutter whole(seamed.whole);
		std::size_t crossed = 0;
		const BruteForceLocator locator(seamed.whole.blocks[0]);
		for (const TestPlane& plane : randomPlanes(seamed.set.bounds(), 60, 90))
		{
			if (locator.cellsHolding(plane.origin).empty())
				continue;
			const SlicedSheet cut = test::cut(cutter, plane, kHotSpot);
			EXPECT_TRUE(cut.slice.seeds.hot_spot_inside) << seamed.name;
			EXPECT_LE(cut.slice.seeds.count, 1u);
			EXPECT_EQ(cut.cutCellCount(), test::cut(whole, plane, kHotSpot).cutCellCount()) << seamed.name;
			crossed += cut.cutCellCount() > 0;
		}
		EXPECT_GT(crossed, 10u) << seamed.name;
	}
}

TEST(Seams, AllOfASheetIsTheScanAndItsPiecesAreThoseOfOneGrid)
{
	for (const SeamedSet& seamed : seamedSets())
	{
		cut::Cutter cutter(seamed.set);
		cut::Cutter whole(seamed.whole);
		for (const TestPlane& plane : randomPlanes(seamed.set.bounds(), 60, 91))
		{
			const SlicedSheet cut = test::cut(cutter, plane);
			const SlicedSheet expected = test::cut(whole, plane);
			for (std::size_t b = 0; b < seamed.set.blocks.size(); ++b)
				EXPECT_EQ(cut.cutCells(b), scanCutCells(seamed.set.blocks[b], plane)) << seamed.name;
			const measure::SheetMeasure here = measure::measure(seamed.set, cut.mesh, {});
			const measure::SheetMeasure there = measure::measure(seamed.whole, expected.mesh, {});
			EXPECT_EQ(here.components, there.components) << seamed.name;
			EXPECT_EQ(cut.mesh.positions.size(), expected.mesh.positions.size()) << seamed.name;
			EXPECT_NEAR(here.area, there.area, 1e-9 * (1.0 + there.area)) << seamed.name;
		}
	}
}

// On the lattice's planes vertices lie at points, and on the seam faces lie in the plane.
TEST(Seams, PlanesThroughPointsShowNothingTwice)
{
	for (const SeamedSet& seamed : seamedSets())
	{
		cut::Cutter cutter(seamed.set);
		cut::Cutter whole(seamed.whole);
		for (int axis = 0; axis < 3; ++axis)
			for (int step = 0; step <= 2 * kSteps; ++step)
			{
				TestPlane plane{Vec3(0.0), Vec3(0.0)};
				plane.origin[axis] = 0.25 * step;
				plane.normal[axis] = 1.0;
				const SlicedSheet cut = test::cut(cutter, plane);
				const SlicedSheet expected = test::cut(whole, plane);
				EXPECT_EQ(cut.cutCellCount(), scanCount(seamed.set, plane));
				const measure::SheetMeasure here = measure::measure(seamed.set, cut.mesh, {});
				const measure::SheetMeasure there = measure::measure(seamed.whole, expected.mesh, {});
				EXPECT_NEAR(here.area + here.boundary_area, there.area + there.boundary_area, 1e-9)
				    << seamed.name << " axis " << axis << " step " << step;
				EXPECT_EQ(here.components, there.components) << seamed.name << " axis " << axis << " step " << step;
			}
	}
}

// Two blocks with an array that jumps at the seam, or does not, and perhaps with ids that differ.
TEST(Seams, VerticesAreOneUnlessAnArrayJumps)
{
	const auto halves = [](double jump, std::int32_t id)
	{
		std::vector<grid::Block> blocks{latticeBlock(straight, 0.0, false), latticeBlock(straight, 1.0, false)};
		for (grid::Block& block : blocks)
		{
			const std::size_t points = (kSteps + 1) * (kSteps + 1) * (kSteps + 1);
			const bool is_first = &block == &blocks[0];
			block.fields.push_back(grid::makeField("p", grid::Association::point, 1,
			                                       std::vector<double>(points, is_first ? 1.0 : 1.0 + jump)));
			block.fields.push_back(grid::makeField("id", grid::Association::point, 1,
			                                       std::vector<std::int32_t>(points, is_first ? 0 : id)));
		}
		return setOfBlocks(std::move(blocks));
	};
	struct Case
	{
		double jump;
		std::int32_t id;
	};
	const TestPlane plane{{1.0, 0.6, 0.6}, {0.0, 0.1, 1.0}};
	const std::size_t one_side = 2 * (kSteps + 1) * (kSteps + 1);
	for (const auto& [jump, id] : {Case{0.0, 0}, Case{1e-6, 0}, Case{0.5, 0}, Case{1e-6, 1000}})
	{
		const grid::BlockSet set = halves(jump, id);
		cut::Cutter cutter(set);
		const SlicedSheet cut = test::cut(cutter, plane);
		const bool is_one = jump < 0.1 && id == 0;
		EXPECT_EQ(cut.mesh.positions.size(), is_one ? one_side - (kSteps + 1) : one_side);
		const std::set pairs(cut.mesh.seam_pairs.begin(), cut.mesh.seam_pairs.end());
		EXPECT_EQ(pairs.size(), is_one ? 0u : kSteps + 1u);
		EXPECT_EQ(measure::measure(set, cut.mesh, {}).components, 1u);
		// Each array is judged by itself: one that does not jump has one value there.
		const RawVector<double> p = mesh::vertexValues(set, cut.mesh, grid::FieldChoice{"p"}.inEach(set), 0);
		const RawVector<double> ids = mesh::vertexValues(set, cut.mesh, grid::FieldChoice{"id"}.inEach(set), 0);
		for (const auto& [v, w] : pairs)
		{
			EXPECT_EQ(p[v] == p[w], jump < 0.1);
			EXPECT_EQ(ids[v] == ids[w], id == 0);
		}
	}
}

TEST(Seams, SheetsKeepToTheirLanes)
{
	const grid::BlockSet set = setOfBlocks({latticeBlock(warped, 0.0, false), latticeBlock(warped, 1.0, true)});
	cut::Cutter cutter(set);
	cut::CutRequest request;
	request.in_generations = true;
	const Vec3 center = warped(0.6, 0.5, 0.5);
	const std::vector<TestPlane> planes{
	    {center, {0.1, 1.0, 0.2}}, {center, {0.2, 0.1, 1.0}}, {center, {1.0, 0.1, 0.2}}};
	for (const TestPlane& plane : planes)
		request.probe.sheets.push_back(probe::makeSheet(plane.origin, plane.normal));
	request.seeds = kHotSpot;
	const cut::Cut together = std::move(cutter.cut(std::move(request)).value());
	for (std::size_t s = 0; s < planes.size(); ++s)
	{
		const SlicedSheet alone = cut(cutter, planes[s], kHotSpot);
		for (std::size_t b = 0; b < set.blocks.size(); ++b)
			EXPECT_EQ(sorted(together.sheets[s].cuts[b].cells().cells), sorted(alone.slice.cuts[b].cells().cells));
		EXPECT_EQ(alone.cutCellCount(), scanCount(set, planes[s]));
	}
}

} // namespace vp::test
