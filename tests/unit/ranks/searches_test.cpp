// Searches that begin in one rank and go on in others, and particles that fly over borders.
#include "one_sheet.h"
#include "ranks/particles/joined_traces.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vp::test
{

namespace
{

// The figures of a sheet, and what is told about the search for it.
struct Told
{
	Figures figures;
	bool hot_spot_inside = false;
	std::optional<Vec3> moved_to;
};

Told toldOf(ranks::Ranks& ranks, const grid::BlockSet& blocks, const cut::CutRequest& request)
{
	const OneSheet sheet(ranks, blocks, request);
	return {figuresOf(ranks, blocks, sheet), sheet.sheet().seeds.hot_spot_inside, sheet.sheet().seeds.moved_to};
}

void expectFoundAsByOne(const cut::CutRequest& request, const std::string& where)
{
	for (const Kind kind : {Kind::lattice, Kind::cells})
		for (const auto& [parts, per_rank] : {std::pair(3, 1u), std::pair(4, 2u)})
		{
			Told expected;
			withOneAndWithMany(
			    {kind, straight, parts, per_rank},
			    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
			    {
				    expected = toldOf(ranks, own, request);
				    EXPECT_GT(expected.figures.polygons, 4u) << where;
			    },
			    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
			    {
				    const Told told = toldOf(ranks, own, request);
				    expectSame(told.figures, expected.figures, where);
				    EXPECT_EQ(ranks.any(told.hot_spot_inside), expected.hot_spot_inside) << where;
				    if (request.seeds.mode == seed::SeedMode::hotspot)
				    {
					    EXPECT_EQ(told.hot_spot_inside, expected.hot_spot_inside) << where;
					    EXPECT_EQ(told.moved_to, expected.moved_to) << where;
				    }
			    });
		}
}

cut::CutRequest fromHotSpot(const TestPlane& plane)
{
	cut::CutRequest request = requestFor(plane);
	request.seeds.mode = seed::SeedMode::hotspot;
	return request;
}

} // namespace

// It moves to the nearest place of the sheet in the grid, which the last rank has.
TEST(Searches, AHotSpotOutsideMovesToTheNearestRank)
{
	expectFoundAsByOne(fromHotSpot({{7.0, 0.4, 0.3}, {0.0, 0.1, 1.0}}), "far");
	expectFoundAsByOne(fromHotSpot({{-3.0, 0.4, 0.3}, {0.0, 0.1, 1.0}}), "before");
}

// On a face between two ranks one of them begins.
TEST(Searches, AHotSpotOnABorderIsOfOneRank)
{
	expectFoundAsByOne(fromHotSpot({{1.0, 0.4, 0.3}, {0.0, 0.1, 1.0}}), "on a border");
	expectFoundAsByOne(fromHotSpot({{1.0, 0.4, 0.3}, {1.0, 0.0, 0.0}}), "in a border");
}

TEST(Searches, AThresholdEndsThemWhereOneProcessEnds)
{
	for (const TestPlane& plane : {TestPlane{{1.0, 0.5, 0.5}, {1.0, 0.0, 0.0}}, // along a border
	                               TestPlane{{1.5, 0.5, 0.0}, {0.0, 0.0, 1.0}}, // along the boundary
	                               TestPlane{{1.3, 0.5, 0.4}, {0.1, 0.3, 1.0}}})
		for (const seed::SeedMode mode : {seed::SeedMode::automatic, seed::SeedMode::boundary})
		{
			cut::CutRequest request = requestFor(plane);
			request.threshold = find::Threshold{-0.3, 0.8};
			request.seeds.mode = mode;
			expectFoundAsByOne(request, mode == seed::SeedMode::boundary ? "boundary" : "automatic");
		}
}

// A sphere about a border reaches the boundary; from there the search goes over the border.
TEST(Searches, CurvedSheetsFromTheBoundaryGoOverBorders)
{
	cut::CutRequest request = requestFor({{1.1, 0.5, 0.1}, {0.0, 0.0, 1.0}});
	request.probe.sheets[0].form = surface::ImplicitSurface::parse("sphere:0.45").value();
	for (const seed::SeedMode mode : {seed::SeedMode::automatic, seed::SeedMode::boundary, seed::SeedMode::hotspot})
	{
		request.seeds.mode = mode;
		expectFoundAsByOne(request, "sphere");
	}
}

// If a hot spot stays where it is, all ranks know whether any of them has it.
TEST(Searches, AllRanksKnowOfAHotSpotThatStays)
{
	for (const double x : {2.4, 9.0})
	{
		cut::CutRequest request = requestFor({{x, 0.4, 0.3}, {0.0, 0.1, 1.0}});
		request.seeds.outside = seed::OutsidePolicy::report;
		withOneAndWithMany(
		    {Kind::lattice, straight, 3}, [](auto&, const auto&) {},
		    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
		    { EXPECT_EQ(OneSheet(ranks, own, request).sheet().seeds.hot_spot_inside, x < 3.0); });
	}
}

// A step leads over a rank whose part is thinner than the step is long.
TEST(Searches, ParticlesStepOverAThinPart)
{
	const std::vector<grid::Block> blocks{withArrays(hexahedraBlock(straight, 0.0, 1.0, true)),
	                                      withArrays(hexahedraBlock(straight, 1.0, 1.25, true)),
	                                      withArrays(hexahedraBlock(straight, 1.25, 2.25, true))};
	const auto follow = [](ranks::Ranks& ranks, const grid::BlockSet& own)
	{
		const OneSheet sheet(ranks, own, requestFor({{0.45, 0.5, 0.5}, {1.0, 0.1, 0.2}}));
		const auto launches = ranks::launchLattice(ranks, sheet.mesh, sheet.sheet().sheet, {.along = 3});
		const vectors::TraceOptions options{.steps = 4.0, .dt = 0.6};
		return std::move(ranks::trace(ranks, own, kWind, launches, options).value());
	};
	vectors::Traces expected;
	withOneAndWithMany(
	    blocks,
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    expected = follow(ranks, own);
		    EXPECT_GT(expected.count(), 4u);
	    },
	    [&](ranks::Ranks& ranks, const grid::BlockSet& own)
	    {
		    const vectors::Traces traces = follow(ranks, own);
		    EXPECT_EQ(traces.starts, expected.starts);
		    EXPECT_EQ(traces.ends, expected.ends);
		    EXPECT_EQ(traces.blocks, expected.blocks);
		    ASSERT_EQ(traces.points.size(), expected.points.size());
		    for (std::size_t i = 0; i < traces.points.size(); ++i)
			    EXPECT_LT(glm::distance(traces.points[i], expected.points[i]), 1e-6) << i;
	    });
}

// Squares of two ranks lie over each other between x = 1 and x = 2. A lattice of 6 x 2 places covers both.
TEST(Searches, OfOverlappingPolygonsTheLastLaunches)
{
	ranks::withTeam(2,
	                [](ranks::Team& team)
	                {
		                const ranks::Ranks ranks = ranksOf(team, false);
		                const auto rank = static_cast<std::uint32_t>(team.rank());
		                mesh::SheetMesh square;
		                for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)})
			                square.positions.push_back(corner + Vec3(rank, 0, 0));
		                square.edges.resize(4);
		                square.polygon_starts = {0, 4};
		                square.polygon_vertices = {0, 1, 2, 3};
		                square.polygon_cells = {{rank, 5 + rank}};
		                const probe::Sheet sheet = probe::makeSheet(Vec3(0.0), Vec3(0.0, 0.0, 1.0));
		                const auto launches = ranks::launchLattice(ranks, square, sheet, {.along = 6});
		                ASSERT_EQ(launches.size(), 12u);
		                for (const vectors::Launch& launch : launches)
		                {
			                EXPECT_EQ(launch.block, launch.position.x < 1.0 ? 0u : 1u) << launch.position.x;
			                EXPECT_EQ(launch.cell, 5 + launch.block);
		                }
	                });
}

} // namespace vp::test
