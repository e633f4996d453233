#include "helix_traces.h"
#include "test_grids.h"

#include "grid/demo/demo.h"
#include "locate/place.h"
#include "vectors/trace_values.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

using vectors::Traces;

// One through the upper half of the demos' grids, its cells looked up.
Traces helixIn(const grid::BlockSet& set)
{
	Traces traces;
	addHelix(traces, 1.7, 0.1, 0, 20);
	locate::PlaceFinder finder(set);
	for (std::size_t i = 0; i < traces.points.size(); ++i)
	{
		Vec3& p = traces.points[i];
		p = onHelix(1.7, 0.5 + 0.1 * static_cast<double>(i));
		traces.vectors[i] = {-p.y, p.x, 0.3};
		const locate::Place& place = finder.find(p);
		EXPECT_TRUE(place.found());
		traces.blocks[i] = place.block;
		traces.cells[i] = place.cell;
	}
	return traces;
}

class OnDemo : public testing::TestWithParam<const char*>
{
};

TEST_P(OnDemo, ALinearArrayIsExactAlongATrace)
{
	const grid::BlockSet set = *grid::makeDemo(GetParam(), 12);
	const Traces traces = helixIn(set);
	const auto x = vectors::valuesAt(set, {"v", grid::Association::point, 1}, traces);
	const auto length = vectors::valuesAt(set, {"v", grid::Association::point, grid::kMagnitude}, traces);
	for (std::size_t i = 0; i < traces.points.size(); ++i)
	{
		const Vec3& p = traces.points[i];
		EXPECT_NEAR(x[i], p.x, 1e-6);
		EXPECT_NEAR(length[i], std::hypot(p.x, p.y, 0.3), 1e-6);
	}
}

TEST_P(OnDemo, TurnsByHalfOfTheCurlAlongTheVector)
{
	const grid::BlockSet set = *grid::makeDemo(GetParam(), 12);
	const Traces traces = helixIn(set);
	const auto turns =
	    vectors::turnsAlong(vectors::turnRates(set, {"v", grid::Association::point, grid::kMagnitude}, traces), traces);
	const double rate = 0.3 / std::hypot(1.7, 0.3); // the curl is (0, 0, 2)
	for (std::size_t i = 0; i < turns.size(); ++i)
		EXPECT_NEAR(turns[i], rate * traces.times[i], 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Kinds, OnDemo, testing::Values("shell", "hexes", "tets", "blob", "graded", "mixed"));

TEST(TraceValues, AreConstantInCellsAndMissingWhereABlockLacksTheArray)
{
	grid::BlockSet set = *grid::makeDemo("shell", 12);
	addTestFields(set.blocks[0]);
	const Traces traces = helixIn(set);
	const auto ids = vectors::valuesAt(set, {"id", grid::Association::cell, 0}, traces);
	for (std::size_t i = 0; i < ids.size(); ++i)
		EXPECT_EQ(ids[i],
		          std::visit([&](const auto& grid) { return static_cast<double>(grid.sourceCell(traces.cells[i])); },
		                     set.blocks[0].grid));
	for (const double value : vectors::valuesAt(set, {"none", grid::Association::point, 0}, traces))
		EXPECT_TRUE(std::isnan(value));
	for (const double turn :
	     vectors::turnsAlong(vectors::turnRates(set, {"none", grid::Association::point, 0}, traces), traces))
		EXPECT_EQ(turn, 0.0);
}

} // namespace

} // namespace vp::test
