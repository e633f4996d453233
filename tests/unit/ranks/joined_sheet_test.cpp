#include "one_sheet.h"
#include "ranks/join/boundary_edges.h"
#include "ranks/join/whole_cells.h"
#include "ranks/particles/joined_traces.h"
#include "ranks/picture/merged_layers.h"
#include "ranks/picture/surroundings.h"
#include "ranks/search/joined_contour.h"
#include "ranks/write/joined_stats.h"
#include "ranks/write/joined_tables.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

namespace vp::test
{

namespace
{

// Askew, along a border of parts, through an edge of the lattice, and one that misses all.
const TestPlane kPlanes[] = {{{1.1, 0.4, 0.3}, {0.8, 0.3, 0.5}},
                             {{1.0, 0.5, 0.5}, {1.0, 0.0, 0.0}},
                             {{0.5, 0.5, 0.25}, {0.0, 0.0, 1.0}},
                             {{0.0, 0.52, 0.3}, {0.1, 1.0, -0.2}},
                             {{9.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}};
constexpr Kind kKinds[] = {Kind::lattice, Kind::cells};
constexpr Place kPlaces[] = {straight, warped};

template <class Test>
void forEachParting(const Test& test)
{
	for (const Kind kind : kKinds)
		for (const Place place : kPlaces)
			for (const auto& [parts, per_rank] : {std::pair(2, 1u), std::pair(3, 1u), std::pair(4, 2u)})
				test(Parting{kind, place, parts, per_rank});
}

// Values of all ranks, as they come.
class Gathered
{
public:
	void add(const ranks::Ranks& ranks, std::size_t own)
	{
		const std::lock_guard lock(mutex_);
		of_rank_[ranks.team() ? ranks.team()->rank() : 0] = own;
	}
	std::size_t sum() const
	{
		std::size_t all = 0;
		for (const auto& [rank, own] : of_rank_)
			all += own;
		return all;
	}

private:
	std::mutex mutex_;
	std::map<int, std::size_t> of_rank_;
};

} // namespace

TEST(RanksAlone, HaveWhatTheProcessHas)
{
	ranks::Ranks alone = ranks::Ranks::alone();
	EXPECT_TRUE(alone.isFirst());
	EXPECT_FALSE(alone.any(false));
	EXPECT_EQ(alone.sum(3, [](int& sum, int other) { sum += other; }), 3);
	EXPECT_EQ(ranks::tableOfAll(alone, "title\n", "a\nb\n"), "title\na\nb\n");
	EXPECT_EQ(ranks::boundsOfAll(alone, mesh::UvBounds()), std::nullopt);
	const grid::BlockSet blocks = wholeOf(Kind::lattice, straight, 1);
	EXPECT_EQ(ranks::documentOfAll(alone, blocks, {{"sheets", 1}}), nlohmann::json({{"sheets", 1}}));
	EXPECT_EQ(ranks::figuresOfAll(alone, {{"sheets", 1}}), nlohmann::json({{"sheets", 1}}));
	EXPECT_EQ(ranks::countsOf(alone, blocks).cells, blocks.cellCount());
	std::int32_t block = 7;
	ranks::nameWholeBlocks(alone, {&block, 1});
	EXPECT_EQ(block, 7);
}

TEST(RanksOfTeam, ToldTablesComeFromAll)
{
	ranks::withTeam(3,
	                [](ranks::Team& team)
	                {
		                const ranks::Ranks ranks(&team);
		                const std::string lines = std::to_string(team.rank()) + " says\n";
		                const std::string table = ranks::tableOfAll(ranks, "who\n", lines);
		                EXPECT_EQ(table,
		                          team.isFirst() ? " rank  who\n    0  0 says\n    1  1 says\n    2  2 says\n" : "");
	                });
}

// Cells, polygons, vertices at borders, pieces and sums: joined, they are those of one process.
TEST(RanksOfTeam, JoinedSheetsAreThoseOfOneProcess)
{
	forEachParting(
	    [](const Parting& parting)
	    {
		    for (const TestPlane& plane : kPlanes)
		    {
			    Figures expected;
			    withOneAndWithMany(
			        parting,
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			        { expected = figuresOf(ranks, blocks, OneSheet(ranks, blocks, requestFor(plane))); },
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			        {
				        expectSame(figuresOf(ranks, blocks, OneSheet(ranks, blocks, requestFor(plane))), expected,
				                   std::to_string(parting.parts) + " parts");
			        });
		    }
	    });
}

// A vertex at a border has one number at all ranks that have it.
TEST(RanksOfTeam, SharedVerticesLieAtOnePlace)
{
	std::mutex mutex;
	std::map<std::uint64_t, std::vector<Vec3>> places;
	withOneAndWithMany(
	    {Kind::lattice, warped, 3}, [](auto&, const auto&) {},
	    [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
	    {
		    const OneSheet sheet(ranks, blocks, requestFor(kPlanes[0]));
		    const std::lock_guard lock(mutex);
		    for (const ranks::SharedVertex& shared : sheet.borders.shared)
			    places[shared.id].push_back(sheet.mesh.positions[shared.vertex]);
	    });
	ASSERT_GE(places.size(), 4u);
	for (const auto& [id, of_ranks] : places)
	{
		EXPECT_EQ(of_ranks.size(), 2u) << id;
		for (const Vec3& at : of_ranks)
			EXPECT_LT(glm::distance(at, of_ranks.front()), 1e-12);
	}
}

// From one hot spot the search goes through all parts; with a threshold it reaches what one process reaches.
TEST(RanksOfTeam, SearchesGoFromRankToRank)
{
	forEachParting(
	    [](const Parting& parting)
	    {
		    for (const bool has_threshold : {false, true})
		    {
			    cut::CutRequest request = requestFor({{0.3, 0.45, 0.3}, {0.1, 0.3, 1.0}});
			    request.seeds.mode = seed::SeedMode::hotspot;
			    if (has_threshold)
				    request.threshold = find::Threshold{-0.4, 0.9};
			    Figures expected;
			    withOneAndWithMany(
			        parting,
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			        {
				        const OneSheet sheet(ranks, blocks, request);
				        expected = figuresOf(ranks, blocks, sheet);
				        EXPECT_GT(expected.cells, 10u);
			        },
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			        {
				        const OneSheet sheet(ranks, blocks, request);
				        expectSame(figuresOf(ranks, blocks, sheet), expected, has_threshold ? "threshold" : "hot spot");
				        EXPECT_TRUE(ranks.any(sheet.sheet().seeds.hot_spot_inside));
			        });
		    }
	    });
}

// Faces between two ranks that both show the cell on their side are shown by neither.
TEST(RanksOfTeam, WholeCellsHaveTheFacesOfOneProcess)
{
	forEachParting(
	    [](const Parting& parting)
	    {
		    for (const TestPlane& plane : {kPlanes[0], kPlanes[3]})
		    {
			    const auto count = [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			    {
				    const OneSheet sheet(ranks, blocks, requestFor(plane));
				    mesh::SheetMesh faces = sheet.cut.crinkle(blocks, 0, sheet.borders.cells_elsewhere);
				    const ranks::Borders borders = ranks::joinWholeCells(ranks, blocks, faces);
				    EXPECT_FALSE(borders.hangs);
				    return std::array{sumOf(ranks, faces.polygons()),
				                      sumOf(ranks, faces.positions.size() - borders.vertices_elsewhere)};
			    };
			    std::array<std::size_t, 2> expected{};
			    withOneAndWithMany(
			        parting,
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks) { expected = count(ranks, blocks); },
			        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
			        { EXPECT_EQ(count(ranks, blocks), expected) << parting.parts << " parts"; });
		    }
	    });
}

// Where a cell meets several smaller ones of another rank, all ranks know that what they have does not fit.
TEST(RanksOfTeam, CellsOfOtherSizesHang)
{
	const auto coarse = curvilinearBlock("coarse", {2, 2, 2}, [](int i, int j, int k) { return Vec3(i - 1.0, j, k); });
	const std::vector<grid::Block> blocks{withArrays(coarse), partOf(Kind::lattice, straight, 0)};
	ranks::withTeam(2,
	                [&](ranks::Team& team)
	                {
		                const ranks::Ranks ranks = ranksOf(team, false);
		                const grid::BlockSet own = shareOf(blocks, team.rank());
		                const OneSheet sheet(ranks, own, requestFor({{0.1, 0.4, 0.3}, {0.1, 0.2, 1.0}}));
		                EXPECT_TRUE(sheet.borders.hangs);
		                EXPECT_FALSE(ranks::boundaryEdgesOfAll(team, ranks.share(), own));
	                });
}

// Particles go from rank to rank, and each has the path that it has in one process.
TEST(RanksOfTeam, PathsAreThoseOfOneProcess)
{
	forEachParting(
	    [](const Parting& parting)
	    {
		    const auto follow = [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		    {
			    const OneSheet sheet(ranks, blocks, requestFor({{0.45, 0.5, 0.5}, {1.0, 0.1, 0.2}}));
			    const auto launches = ranks::launchLattice(ranks, sheet.mesh, sheet.sheet().sheet, {.along = 4});
			    vectors::TraceOptions options{.steps = 12.0, .dt = 0.2};
			    options.direction = vectors::Direction::both;
			    vectors::Traces traces = std::move(ranks::trace(ranks, blocks, kWind, launches, options).value());
			    std::vector<double> heights(traces.points.size());
			    for (std::size_t i = 0; i < heights.size(); ++i)
				    if (ranks::isHere(ranks, traces.blocks[i]))
					    heights[i] = traces.points[i].x;
			    ranks::takeFromOwners(ranks, blocks, traces, heights);
			    for (std::size_t i = 0; i < heights.size(); ++i)
				    EXPECT_EQ(heights[i], traces.points[i].x);
			    return traces;
		    };
		    vectors::Traces expected;
		    withOneAndWithMany(
		        parting,
		        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		        {
			        expected = follow(ranks, blocks);
			        EXPECT_GT(expected.count(), 8u);
		        },
		        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		        {
			        const vectors::Traces traces = follow(ranks, blocks);
			        EXPECT_EQ(traces.starts, expected.starts);
			        EXPECT_EQ(traces.seeds, expected.seeds);
			        EXPECT_EQ(traces.ends, expected.ends);
			        EXPECT_EQ(traces.begins, expected.begins);
			        ASSERT_EQ(traces.points.size(), expected.points.size());
			        for (std::size_t i = 0; i < traces.points.size(); ++i)
				        EXPECT_LT(glm::distance(traces.points[i], expected.points[i]), 1e-6) << i;
		        });
	    });
}

// Contours grow through all parts within one box.
TEST(RanksOfTeam, ContoursAreThoseOfOneProcess)
{
	forEachParting(
	    [](const Parting& parting)
	    {
		    const auto grow = [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		    {
			    OneSheet sheet(ranks, blocks, requestFor({{0.5, 0.5, 0.45}, {0.1, 0.2, 1.0}}));
			    const Box rect = ranks::rectOf(ranks, sheet.sheet(), sheet.mesh);
			    contour::BoxContourer contourer(sheet.cutter, sheet.sheet(), sheet.mesh,
			                                    contour::boxOf(sheet.sheet(), rect, 0.7));
			    ranks::shareRange(ranks, contourer);
			    const double values[] = {0.2, -0.3};
			    auto contours = ranks::growContours(ranks, blocks, contourer, values, nullptr);
			    std::vector<std::array<double, 3>> told;
			    for (const ranks::GrownContour& contour : contours.value())
			    {
				    const double area = measure::measureOf(ranks::sumUp(ranks, blocks, contour.mesh, {}), false).area;
				    told.push_back({double(sumOf(ranks, contour.cells)), double(contour.components), area});
			    }
			    return told;
		    };
		    std::vector<std::array<double, 3>> expected;
		    withOneAndWithMany(
		        parting,
		        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		        {
			        expected = grow(ranks, blocks);
			        EXPECT_GT(expected.at(0)[0], 10.0);
		        },
		        [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		        {
			        const auto told = grow(ranks, blocks);
			        ASSERT_EQ(told.size(), expected.size());
			        for (std::size_t c = 0; c < told.size(); ++c)
			        {
				        EXPECT_EQ(told[c][0], expected[c][0]);
				        EXPECT_EQ(told[c][1], expected[c][1]);
				        EXPECT_NEAR(told[c][2], expected[c][2], 1e-12);
			        }
		        });
	    });
}

// What is drawn around the sheets does not show how a lattice is parted.
TEST(RanksOfTeam, OutlinesAreThoseOfOneProcess)
{
	for (const render::Outline outline : {render::Outline::box, render::Outline::edges})
	{
		const auto lines = [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		{
			std::vector<std::array<double, 6>> sorted;
			const ranks::Surroundings around = std::move(ranks::surroundingsOf(ranks, blocks, outline).value());
			for (const render::Segment& s : around.outline)
			{
				std::array<double, 3> a{s.a.x, s.a.y, s.a.z};
				std::array<double, 3> b{s.b.x, s.b.y, s.b.z};
				if (b < a)
					std::swap(a, b);
				sorted.push_back({a[0], a[1], a[2], b[0], b[1], b[2]});
			}
			std::ranges::sort(sorted);
			return sorted;
		};
		std::vector<std::array<double, 6>> expected;
		withOneAndWithMany(
		    {Kind::lattice, warped, 3},
		    [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		    {
			    expected = lines(ranks, blocks);
			    EXPECT_GE(expected.size(), 12u);
		    },
		    [&](ranks::Ranks& ranks, const grid::BlockSet& blocks) { EXPECT_EQ(lines(ranks, blocks), expected); });
	}
}

// The first rank writes the polygons of all.
TEST(RanksOfTeam, TheFirstHasTheTableOfAll)
{
	for (const Kind kind : kKinds)
	{
		std::size_t expected = 0;
		Gathered own;
		std::size_t written = 0;
		withOneAndWithMany(
		    {kind, warped, 3},
		    [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		    {
			    const OneSheet sheet(ranks, blocks, requestFor(kPlanes[0]));
			    expected = ranks::tabulate(ranks, blocks, {&sheet.mesh, 1}, {}).cell.size();
		    },
		    [&](ranks::Ranks& ranks, const grid::BlockSet& blocks)
		    {
			    const OneSheet sheet(ranks, blocks, requestFor(kPlanes[0]));
			    own.add(ranks, sheet.mesh.polygons());
			    const write::SliceTable table = ranks::tabulate(ranks, blocks, {&sheet.mesh, 1}, {});
			    if (!ranks.isFirst())
				    return;
			    written = table.cell.size();
			    const std::int32_t last_block = kind == Kind::lattice ? 0 : 1; // the plane does not reach the last part
			    EXPECT_EQ(table.block.front(), 0);
			    EXPECT_EQ(table.block.back(), last_block);
		    });
		EXPECT_EQ(written, expected);
		EXPECT_EQ(own.sum(), expected);
	}
}

} // namespace vp::test
