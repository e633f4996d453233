#include "cut_both_ways.h"
#include "gpu_fixture.h"
#include "test_grids.h"
#include "tries.h"
#include "uploaded.h"

#include "base/timeline.h"
#include "gpu/upload.h"

#include <cmath>
#include <thread>

namespace vp::test
{

namespace
{

using grid::FieldChoice;

FieldChoice pointField(const char* name, int component = 0)
{
	return {name, grid::Association::point, component};
}

grid::BlockSet setNamed(std::initializer_list<const char*> names)
{
	grid::BlockSet set;
	for (const char* name : names)
		set.blocks.push_back(gridNamed(name));
	return set;
}

probe::Sheet sheetOf(const TestPlane& plane)
{
	return probe::makeSheet(plane.origin, plane.normal, {0.3, 1.0, 0.2});
}

// Random planes and degenerate ones through every test grid.
void cutAllGrids(gpu::Device& device, const classify::GpuBlocksOptions& options, bool singles)
{
	Taken taken;
	for (const grid::Block& block : allGrids())
	{
		SCOPED_TRACE(block.name);
		grid::BlockSet set;
		set.blocks.push_back(block);
		const auto blocks = upload(device, set, options);
		EXPECT_EQ(blocks->usesDoubles(), !singles && device.hasExactDoubles());
		std::vector<TestPlane> planes = randomPlanes(block.bounds, 10, 3);
		const std::vector<TestPlane> hard = degeneratePlanes(block, 5);
		planes.insert(planes.end(), hard.begin(), hard.end());
		for (const TestPlane& plane : planes)
		{
			if (!taken.next())
				continue;
			const probe::Sheet sheet = sheetOf(plane);
			const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("linear"));
			expectSameCells(cut);
			expectRecords(set, std::span(&sheet, 1), pointField("linear"), cut);
			if (testing::Test::HasFailure())
			{
				ADD_FAILURE() << "plane at " << plane.origin.x << ' ' << plane.origin.y << ' ' << plane.origin.z
				              << ", normal " << plane.normal.x << ' ' << plane.normal.y << ' ' << plane.normal.z;
				return;
			}
		}
	}
}

} // namespace

using GpuClassifier = GpuTest;
using StagedGpuClassifier = StagedGpuTest;

TEST_F(GpuClassifier, AgreesWithTheCpuOnEveryGrid)
{
	cutAllGrids(device(), {}, false);
}

TEST_F(GpuClassifier, AgreesWithTheCpuWithoutDoubles)
{
	classify::GpuBlocksOptions options;
	options.doubles = false;
	cutAllGrids(device(), options, true);
}

TEST_F(StagedGpuClassifier, AgreesWithTheCpu)
{
	const grid::BlockSet set = setNamed({"mixed_polyhedra"});
	const auto blocks = upload(device(), set);
	for (const TestPlane& plane : randomPlanes(set.bounds(), 5, 7))
	{
		const probe::Sheet sheet = sheetOf(plane);
		const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("linear"));
		expectSameCells(cut);
		expectRecords(set, std::span(&sheet, 1), pointField("linear"), cut);
	}
}

TEST_F(GpuClassifier, SheetsInLockStepCrossInTheSameCells)
{
	const grid::BlockSet set = setNamed({"shell"});
	const auto blocks = upload(device(), set);
	const Vec3 center = set.bounds().center();
	const std::vector<probe::Sheet> sheets{probe::makeSheet(center, {1, 0.1, 0}), probe::makeSheet(center, {0, 1, 0.2}),
	                                       probe::makeSheet(center, {-0.3, 0, -1})};
	const CutBothWays cut = cutBothWays(*blocks, sheets, pointField("s"));
	expectSameCells(cut);
	expectRecords(set, sheets, pointField("s"), cut);
	for (const find::CellCut& lane : cut.gpu)
		EXPECT_GT(lane.cut_cells, 20u);
}

TEST_F(GpuClassifier, FrontsStraddlePages)
{
	const grid::BlockSet set = setNamed({"shell", "hexes"});
	classify::GpuBlocksOptions options;
	options.page_records = 64; // less than a wide front
	const auto blocks = upload(device(), set, options);
	const std::vector<probe::Sheet> sheets{probe::makeSheet(set.bounds().center(), {1, 0.3, 0.4}),
	                                       probe::makeSheet(set.bounds().center(), {0.2, 1, 0.1})};
	const CutBothWays cut = cutBothWays(*blocks, sheets, pointField("v", grid::kMagnitude));
	expectSameCells(cut);
	expectRecords(set, sheets, pointField("v", grid::kMagnitude), cut);
	EXPECT_GT(cut.records[0]->pages.size(), 2u);
}

TEST_F(GpuClassifier, BlocksOfEveryKindInOneSet)
{
	const grid::BlockSet set =
	    setNamed({"blob", "graded", "shell", "tets", "mixed", "hexagonal_prisms", "warped_curvilinear"});
	const auto blocks = upload(device(), set);
	EXPECT_EQ(blocks->heldCount(), set.blocks.size());
	const std::vector<probe::Sheet> sheets{probe::makeSheet({0.1, 0.2, 0.3}, {1, 0.3, 0.4}),
	                                       probe::makeSheet({0.1, 0.2, 0.3}, {-1, 0.3, 0.4})};
	const CutBothWays cut = cutBothWays(*blocks, sheets, pointField("s"));
	expectSameCells(cut);
	// "s" is in the demo blocks only: elsewhere there is no value.
	expectRecords(set, sheets, pointField("s"), cut);
}

TEST_F(GpuClassifier, ShowsAnyArray)
{
	const grid::BlockSet set = setNamed({"shell"});
	const auto blocks = upload(device(), set);
	const probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {1, 0.3, 0.4});
	const std::vector<std::optional<FieldChoice>> choices{std::nullopt,
	                                                      pointField("v", 1),
	                                                      pointField("v", grid::kMagnitude),
	                                                      pointField("linear"),
	                                                      FieldChoice{"id", grid::Association::cell, 0},
	                                                      FieldChoice{"id", grid::Association::cell, grid::kMagnitude},
	                                                      pointField("missing")};
	for (const auto& choice : choices)
	{
		SCOPED_TRACE(choice ? choice->name : "none");
		const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), choice);
		expectSameCells(cut);
		expectRecords(set, std::span(&sheet, 1), choice, cut);
	}
}

TEST_F(GpuClassifier, CategoriesAreNotInterpolated)
{
	grid::Block block = gridNamed("shell");
	const std::size_t points = visitGrid(block, [](const auto& grid) { return grid.pointCount(); });
	std::vector<std::int32_t> materials(points);
	for (std::size_t i = 0; i < points; ++i)
		materials[i] = static_cast<std::int32_t>(i * 7 % 10);
	block.fields.push_back(grid::makeField("material", grid::Association::point, 1, std::move(materials)));
	grid::finishBlock(block);
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	const auto blocks = upload(device(), set);
	const probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {1, 0.3, 0.4});
	for (const int component : {0, grid::kMagnitude})
	{
		const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("material", component));
		expectSameCells(cut);
		expectRecords(set, std::span(&sheet, 1), pointField("material", component), cut);
	}
}

TEST_F(GpuClassifier, NanAndInfiniteDataKeepTheirMarks)
{
	grid::Block block = gridNamed("blob");
	const std::size_t points = visitGrid(block, [](const auto& grid) { return grid.pointCount(); });
	std::vector<double> holes(points);
	for (std::size_t i = 0; i < points; ++i)
		holes[i] = i % 7 == 0 ? std::nan("") : static_cast<double>(i);
	block.fields.push_back(grid::makeField("holes", grid::Association::point, 1, std::move(holes)));
	grid::BlockSet set;
	set.blocks.push_back(std::move(block));
	const auto blocks = upload(device(), set);
	// Through a layer of points: a NaN at the far end of an edge has no part in a vertex at the near end.
	for (const double z : {0.0, 0.1})
	{
		const probe::Sheet sheet = probe::makeSheet({0.0, 0.0, z}, {0, 0, 1});
		const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("holes"));
		expectSameCells(cut);
		expectRecords(set, std::span(&sheet, 1), pointField("holes"), cut);
	}
}

TEST_F(GpuClassifier, PlanesThroughVerticesAreDecidedOnTheDevice)
{
	// Coordinates that are exact on the device leave nothing to walk.
	for (const char* name : {"blob", "graded", "shell"})
	{
		SCOPED_TRACE(name);
		const grid::BlockSet set = setNamed({name});
		const auto blocks = upload(device(), set);
		if (!blocks->usesDoubles())
			GTEST_SKIP() << device().name() << " has no doubles";
		for (const TestPlane& plane : degeneratePlanes(set.blocks[0], 11))
		{
			const probe::Sheet sheet = sheetOf(plane);
			EXPECT_EQ(cutBothWays(*blocks, std::span(&sheet, 1), {}).walked, 0u);
		}
	}
}

TEST_F(GpuClassifier, BlockPastALimitStaysWithTheCpu)
{
	const grid::BlockSet set = setNamed({"shell", "tets"});
	classify::GpuBlocksOptions options;
	// tets has fewer points but more cells than shell has points.
	options.max_elements = visitGrid(set.blocks[0], [](const auto& grid) { return grid.pointCount(); });
	auto cells = visitGrid(set.blocks[1], [](const auto& grid) { return grid.cellCount(); });
	if (cells <= options.max_elements)
		options.max_elements = cells - 1;
	const auto blocks = upload(device(), set, options);
	ASSERT_EQ(blocks->warnings().size(), 2u - blocks->heldCount());
	EXPECT_LT(blocks->heldCount(), 2u);
	const probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {1, 0.3, 0.4});
	const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("linear"));
	expectSameCells(cut);
	for (const classify::SheetRecords::Run& run : cut.records[0]->runs)
		EXPECT_TRUE(blocks->holds(run.block));
}

TEST_F(GpuClassifier, SlicesUnderWayDoNotDisturbEachOther)
{
	const grid::BlockSet set = setNamed({"shell", "mixed"});
	const auto blocks = upload(device(), set);
	const std::vector<TestPlane> planes = randomPlanes(set.bounds(), 4, 13);
	std::vector<std::thread> threads;
	std::vector<std::vector<CutBothWays>> cuts(planes.size());
	for (std::size_t t = 0; t < planes.size(); ++t)
		threads.emplace_back(
		    [&, t]
		    {
			    const probe::Sheet sheet = sheetOf(planes[t]);
			    const auto field = t % 2 ? pointField("s") : pointField("linear");
			    for (int i = 0; i < 5; ++i)
				    cuts[t].push_back(cutBothWays(*blocks, std::span(&sheet, 1), field));
		    });
	for (std::thread& thread : threads)
		thread.join();
	for (std::size_t t = 0; t < planes.size(); ++t)
	{
		const probe::Sheet sheet = sheetOf(planes[t]);
		for (const CutBothWays& cut : cuts[t])
		{
			expectSameCells(cut);
			expectRecords(set, std::span(&sheet, 1), t % 2 ? pointField("s") : pointField("linear"), cut);
		}
	}
}

TEST_F(GpuClassifier, PagesAreUsedAgain)
{
	const grid::BlockSet set = setNamed({"shell"});
	const auto blocks = upload(device(), set);
	std::size_t bytes = 0;
	for (int i = 0; i < 8; ++i)
	{
		const probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {1, 0.1 * i, 0.4});
		const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("s"));
		expectRecords(set, std::span(&sheet, 1), pointField("s"), cut);
		if (i == 0)
			bytes = blocks->bytes();
	}
	EXPECT_EQ(blocks->bytes(), bytes);
}

TEST_F(GpuClassifier, GenerationsAreOnTheTimeline)
{
	if (device().timestampBits() == 0)
		GTEST_SKIP() << device().name() << " has no timestamps";
	const grid::BlockSet set = setNamed({"shell"});
	const auto blocks = upload(device(), set);
	const probe::Sheet sheet = probe::makeSheet(set.bounds().center(), {1, 0.1, 0.4});
	Timeline timeline(Timeline::Keep::sections);
	const CutBothWays cut = cutBothWays(*blocks, std::span(&sheet, 1), pointField("s"), &timeline);
	EXPECT_EQ(timeline.takeSections().size(), cut.gpu[0].generations());
	EXPECT_GT(timeline.totalGpu(), 0.0);
}

TEST_F(GpuClassifier, HostRecordsFollowThoseOfTheDevice)
{
	const auto pool = classify::RecordPool::create(device(), 100);
	std::vector<shared::PolygonRecord> records(250);
	for (std::size_t i = 0; i < records.size(); ++i)
		records[i] = {static_cast<std::uint32_t>(i), 3, {0, 0, 1, 0, 0, 1}, {1, 2, 3}};
	const auto sheet = classify::recordsFromHost(pool, records);
	ASSERT_TRUE(sheet);
	ASSERT_EQ((*sheet)->pages.size(), 3u);
	EXPECT_EQ((*sheet)->count(), records.size());
	std::size_t next = 0;
	for (const classify::SheetRecords::Page& page : (*sheet)->pages)
	{
		std::vector<shared::PolygonRecord> back(page.count);
		ASSERT_TRUE(gpu::download(page.page->buffer, 0, std::as_writable_bytes(std::span(back))));
		for (const shared::PolygonRecord& record : back)
			EXPECT_EQ(record.cell, next++);
	}
}

} // namespace vp::test
