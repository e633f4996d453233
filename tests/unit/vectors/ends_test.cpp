#include "launched.h"
#include "seamed_sets.h"

#include <gtest/gtest.h>

#include <limits>
#include <string_view>

namespace vp::test
{

using vectors::Direction;
using vectors::Launch;
using vectors::TraceEnd;
using vectors::TraceOptions;
using vectors::Traces;

namespace
{

using VectorAt = Vec3 (*)(const Vec3& place);

// A vector array "w" over the points of a block, or over its cells at their centers.
void addVectors(grid::Block& block, VectorAt at, grid::Association association = grid::Association::point)
{
	std::visit(
	    [&](const auto& grid)
	    {
		    const bool on_points = association == grid::Association::point;
		    std::vector<double> values(3 * (on_points ? grid.pointCount() : grid.cellCount()));
		    for (std::size_t i = 0; i < values.size() / 3; ++i)
		    {
			    const auto id = static_cast<std::uint32_t>(i);
			    const Vec3 w = at(on_points ? grid.point(id) : grid::cellCenter(grid, id));
			    const std::size_t tuple = on_points ? grid.sourcePoint(id) : grid.sourceCell(id);
			    for (int c = 0; c < 3; ++c)
				    values[3 * tuple + c] = w[c];
		    }
		    block.fields.push_back(grid::makeField("w", association, 3, std::move(values)));
	    },
	    block.grid);
}

// The unit cube as n^3 voxels.
grid::BlockSet unitBox(VectorAt at, grid::Association association = grid::Association::point, std::uint32_t n = 8)
{
	grid::Block block;
	block.grid = grid::UniformGrid({n + 1, n + 1, n + 1}, Vec3(0.0), Vec3(1.0 / n));
	addVectors(block, at, association);
	grid::finishBlock(block);
	return setOfBlocks({block});
}

Vec3 centerOf(const grid::Block& block, CellId cell)
{
	return std::visit([&](const auto& grid) { return grid::cellCenter(grid, cell); }, block.grid);
}

Traces one(const grid::BlockSet& blocks, const Vec3& from, const TraceOptions& options)
{
	const CellId near = locate::findCell(blocks.blocks[0], kNoCell, from).cell;
	const std::vector<Launch> launches{{from, 0, near, 7}};
	Traces traces = traced(blocks, launches, options, "w");
	EXPECT_EQ(traces.seeds[0], 7u);
	return traces;
}

TraceOptions steps(double number, double dt)
{
	TraceOptions options;
	options.steps = number;
	options.dt = dt;
	return options;
}

} // namespace

TEST(TraceEnds, OnTheBoundaryWhereItLeaves)
{
	const grid::BlockSet box = unitBox([](const Vec3&) { return Vec3(1.0, 0.5, 0.0); });
	TraceOptions options = steps(100, 0.3);
	options.direction = Direction::both;
	const Traces traces = one(box, {0.4, 0.5, 0.3}, options);
	EXPECT_EQ(traces.begins[0], TraceEnd::left_grid);
	EXPECT_EQ(traces.ends[0], TraceEnd::left_grid);
	EXPECT_LT(glm::length(traces.points.front() - Vec3(0.0, 0.3, 0.3)), 1e-8);
	EXPECT_LT(glm::length(traces.points.back() - Vec3(1.0, 0.8, 0.3)), 1e-8);
	EXPECT_NEAR(traces.times.back(), 0.6, 1e-8);
	EXPECT_NEAR(traces.times.front(), -0.4, 1e-8);
	EXPECT_EQ(traces.times[traces.launches[0]], 0.0);
	EXPECT_EQ(traces.count(), 1u);
	EXPECT_EQ(traces.size(0), 5u); // -0.4, -0.3, 0, 0.3, 0.6
}

TEST(TraceEnds, OnTheCurvedBoundaryOfEveryDemo)
{
	for (const grid::Demo& kind : grid::demos())
	{
		// Depths are in parts of a cell, and here cells are up to 10 000 times as long as thick: docs/VECTORS.md.
		if (std::string_view(kind.name) == "layer")
			continue;
		const grid::BlockSet blocks = demo(kind.name, 10);
		const vectors::SheetLattice lattice = latticeOn(blocks, {{0.1, 0.9, 0.2}, {0.2, 0.4, 0.8}});
		TraceOptions options = steps(40, 0.5);
		options.direction = Direction::both;
		const Traces traces = traced(blocks, lattice.launches, options);
		int left = 0;
		for (std::size_t t = 0; t < traces.count(); ++t)
		{
			EXPECT_TRUE(traces.ends[t] == TraceEnd::steps || traces.ends[t] == TraceEnd::left_grid) << kind.name;
			if (traces.ends[t] != TraceEnd::left_grid)
				continue;
			++left;
			locate::CellWeights weights;
			const std::size_t last = traces.starts[t + 1] - 1;
			locate::weighCell(blocks.blocks[0], traces.cells[last], traces.points[last], weights);
			EXPECT_NEAR(weights.depth, 0.0, 1e-6) << kind.name;
		}
		EXPECT_GT(left, 10) << kind.name;
	}
}

TEST(TraceEnds, WhereNothingMoves)
{
	const grid::BlockSet box = unitBox([](const Vec3& p) { return p.x < 0.5 ? Vec3(0.0) : Vec3(1.0, 0.0, 0.0); });
	const Traces still = one(box, {0.2, 0.5, 0.5}, steps(10, 0.1));
	EXPECT_EQ(still.ends[0], TraceEnd::zero_vector);
	EXPECT_EQ(still.begins[0], TraceEnd::steps);
	EXPECT_EQ(still.size(0), 1u);
	EXPECT_EQ(one(box, {0.6, 0.5, 0.5}, steps(2, 0.1)).ends[0], TraceEnd::steps);
}

TEST(TraceEnds, WhereVectorsAreNotKnown)
{
	const grid::BlockSet box = unitBox(
	    [](const Vec3& p) { return p.x > 0.7 ? Vec3(std::numeric_limits<double>::quiet_NaN()) : Vec3(1.0, 0.0, 0.0); });
	const Traces traces = one(box, {0.2, 0.5, 0.5}, steps(100, 0.1));
	EXPECT_EQ(traces.ends[0], TraceEnd::no_vector);
	EXPECT_NEAR(traces.points.back().x, 0.625, 1e-3); // the cells behind have a corner without
	const Traces lost = one(box, {0.9, 0.5, 0.5}, steps(100, 0.1));
	EXPECT_EQ(lost.ends[0], TraceEnd::no_vector);
	EXPECT_EQ(lost.size(0), 1u);
	EXPECT_TRUE(std::isnan(lost.vectors[0].x));
}

TEST(TraceEnds, AStepOverThousandsOfCellsIsGivenUp)
{
	const grid::BlockSet box = unitBox([](const Vec3& p) { return Vec3(0.5 - p.y, p.x - 0.5, 0.0); });
	const Traces traces = one(box, {0.7, 0.5, 0.5}, steps(3, 1e9));
	EXPECT_EQ(traces.ends[0], TraceEnd::gave_up);
	EXPECT_EQ(traces.size(0), 2u);
	EXPECT_GT(traces.times.back(), 100.0);
}

TEST(TraceEnds, VectorsThatRunAgainstEachOtherHoldAParticle)
{
	const grid::BlockSet box =
	    unitBox([](const Vec3& p) { return Vec3(p.x < 0.5 ? 1.0 : -1.0, 0.0, 0.0); }, grid::Association::cell);
	const Traces traces = one(box, {0.2, 0.55, 0.55}, steps(100, 0.1));
	EXPECT_EQ(traces.ends[0], TraceEnd::zero_vector);
	EXPECT_NEAR(traces.points.back().x, 0.5, 1e-8);
}

TEST(Trace, VectorsOfCellsAreConstantInEach)
{
	const grid::BlockSet box = unitBox(
	    [](const Vec3& p) { return Vec3(p.x < 0.5 ? 1.0 : 2.0, p.x < 0.5 ? 0.0 : 1.0, 0.0); }, grid::Association::cell);
	const Traces traces = one(box, {0.2, 0.3, 0.55}, steps(4, 0.11));
	ASSERT_EQ(traces.size(0), 5u);
	EXPECT_NEAR(traces.points.back().x, 0.5 + 2.0 * (0.44 - 0.3), 1e-8);
	EXPECT_NEAR(traces.points.back().y, 0.3 + (0.44 - 0.3), 1e-8);
}

// From block to block through faces that do not share points, also where the axes of one are turned.
TEST(Trace, CrossesSeams)
{
	int crossed = 0;
	for (const Place place : {straight, warped, ring})
	{
		std::vector<grid::Block> blocks{latticeBlock(place, 0.0, false), latticeBlock(place, 1.0, true)};
		for (grid::Block& block : blocks)
			addVectors(block, [](const Vec3& p) { return Vec3(-p.y, p.x, 0.1); });
		const grid::BlockSet set = setOfBlocks(blocks);
		grid::BlockSet merged = setOfBlocks({hexahedraBlock(place, 0.0, 2.0, true)});
		addVectors(merged.blocks[0], [](const Vec3& p) { return Vec3(-p.y, p.x, 0.1); });
		for (CellId cell = kSteps - 1; cell < cellCount(set.blocks[0]); cell += kSteps)
		{
			TraceOptions options = steps(60, 0.05);
			options.direction = Direction::both;
			const Vec3 from = centerOf(set.blocks[0], cell);
			const Traces in_two = one(set, from, options);
			const Traces in_one = one(merged, from, options);
			crossed += in_two.blocks.front() != in_two.blocks.back();
			ASSERT_EQ(in_two.size(0), in_one.size(0));
			EXPECT_EQ(in_two.ends[0], in_one.ends[0]);
			for (std::size_t i = 0; i < in_two.points.size(); ++i)
				EXPECT_LT(glm::length(in_two.points[i] - in_one.points[i]), 1e-4);
		}
	}
	EXPECT_GT(crossed, 10);
}

// Blocks that lie over each other in part, and meet in no face.
TEST(Trace, GoesOnInABlockThatOverlaps)
{
	std::vector<grid::Block> blocks(2);
	blocks[0].grid = grid::UniformGrid({5, 5, 5}, Vec3(0.0), Vec3(0.25));
	blocks[1].grid = grid::UniformGrid({8, 8, 8}, Vec3(0.9, 0.0, 0.0), Vec3(0.15));
	for (grid::Block& block : blocks)
	{
		addVectors(block, [](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
		grid::finishBlock(block);
	}
	const Traces traces = one(setOfBlocks(blocks), {0.1, 0.4, 0.4}, steps(100, 0.1));
	EXPECT_EQ(traces.blocks.back(), 1u);
	EXPECT_NEAR(traces.points.back().x, 0.9 + 7 * 0.15, 1e-8);
}

TEST(TraceEnds, InABlockWithoutTheArray)
{
	std::vector<grid::Block> blocks{latticeBlock(straight, 0.0, false), latticeBlock(straight, 1.0, false)};
	addVectors(blocks[0], [](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
	const Traces traces = one(setOfBlocks(blocks), {0.3, 0.4, 0.4}, steps(100, 0.1));
	EXPECT_EQ(traces.ends[0], TraceEnd::no_vector);
	EXPECT_NEAR(traces.points.back().x, 1.0, 1e-8);
}

TEST(TraceEnds, AtOnceOutsideTheGrid)
{
	const grid::BlockSet box = unitBox([](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
	const Traces traces = one(box, {1.5, 0.4, 0.4}, steps(5, 0.1));
	EXPECT_EQ(traces.ends[0], TraceEnd::left_grid);
	EXPECT_EQ(traces.size(0), 1u);
}

TEST(Trace, ALaunchWithoutACellIsLookedFor)
{
	const grid::BlockSet box = unitBox([](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
	const std::vector<Launch> launches{{Vec3(0.31, 0.42, 0.53), 0, kNoCell, 0}};
	const Traces traces = traced(box, launches, steps(1, 0.1), "w");
	EXPECT_EQ(traces.cells[0], std::get<grid::UniformGrid>(box.blocks[0].grid).cell(2, 3, 4));
	EXPECT_EQ(traces.ends[0], TraceEnd::steps);
}

// Hidden cells, as the reader leaves them out.
TEST(TraceEnds, AtHiddenCells)
{
	grid::BlockSet set = setOfBlocks({gridNamed("two_pieces")});
	addVectors(set.blocks[0], [](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
	const Traces traces = one(set, {0.1, 0.4, 0.4}, steps(100, 0.1));
	EXPECT_EQ(traces.ends[0], TraceEnd::left_grid);
	EXPECT_NEAR(traces.points.back().x, 1.0 / 3.0, 1e-8);
}

} // namespace vp::test
