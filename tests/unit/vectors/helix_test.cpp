#include "launched.h"
#include "tries.h"

#include <gtest/gtest.h>

namespace vp::test
{

using vectors::Direction;
using vectors::TraceEnd;
using vectors::TraceOptions;
using vectors::Traces;

namespace
{

double worstError(const Traces& traces)
{
	double worst = 0.0;
	for (std::size_t t = 0; t < traces.count(); ++t)
	{
		const Vec3 launch = traces.points[traces.launches[t]];
		for (std::size_t i = traces.first(t); i < traces.first(t) + traces.size(t); ++i)
			worst = std::max(worst, glm::length(traces.points[i] - alongHelix(launch, traces.times[i])));
	}
	return worst;
}

// With the vector "w", (-y, x, 0.3) from the middle of the bounds.
grid::BlockSet turningAboutItsMiddle(const grid::Block& plain)
{
	grid::BlockSet blocks = setOf(plain);
	grid::Block& block = blocks.blocks[0];
	std::vector<double> values;
	std::visit(
	    [&](const auto& grid)
	    {
		    values.resize(3 * grid.pointCount());
		    for (PointId p = 0; p < grid.pointCount(); ++p)
		    {
			    const Vec3 off = grid.point(p) - block.bounds.center();
			    const Vec3 w(-off.y, off.x, 0.3);
			    for (int c = 0; c < 3; ++c)
				    values[3 * grid.sourcePoint(p) + c] = w[c];
		    }
	    },
	    block.grid);
	block.fields.push_back(grid::makeField("w", grid::Association::point, 3, std::move(values)));
	grid::matchInterfaces(blocks);
	return blocks;
}

} // namespace

TEST(Trace, FollowsTheHelixOnEveryDemo)
{
	Taken taken;
	for (const grid::Demo& demo_set : grid::demos())
	{
		const grid::BlockSet blocks = demo(demo_set.name, 12);
		const vectors::SheetLattice lattice = latticeOn(blocks, kAskew);
		ASSERT_GT(lattice.launches.size(), 50u) << demo_set.name;
		for (const double dt : {0.01, 0.3, 5.0})
		{
			if (!taken.next())
				continue;
			TraceOptions options;
			options.dt = dt;
			options.steps = 20.0 / dt;
			options.direction = Direction::both;
			const Traces traces = traced(blocks, lattice.launches, options);
			ASSERT_EQ(traces.count(), lattice.launches.size());
			EXPECT_LT(worstError(traces), 1e-3) << demo_set.name << " " << dt;
		}
	}
}

// Every shape of cell and every hard place. A linear field is interpolated exactly in all of them, so the path is the
// helix about the grid's middle until it leaves the grid; and it is the grid, as an exhaustive search tells, that it
// leaves.
TEST(Trace, FollowsTheHelixOnEveryTestGrid)
{
	for (const grid::Block& plain : allGrids())
	{
		const grid::BlockSet blocks = turningAboutItsMiddle(plain);
		const grid::Block& block = blocks.blocks[0];
		const Vec3 middle = block.bounds.center();
		locate::CellWeights weights;
		std::vector<vectors::Launch> launches;
		for (CellId c = 0; c < cellCount(block); c += tryEvery())
			launches.push_back(
			    {std::visit([&](const auto& grid) { return cellCenter(grid, c); }, block.grid), 0, c, c});
		TraceOptions options;
		options.steps = 60.0;
		options.dt = 0.1;
		const Traces traces = traced(blocks, launches, options, "w");
		const double size = block.bounds.diagonal();
		for (std::size_t t = 0; t < traces.count(); ++t)
		{
			const std::span<const Vec3> path = traces.path(t);
			ASSERT_TRUE(traces.ends[t] == TraceEnd::steps || traces.ends[t] == TraceEnd::left_grid)
			    << block.name << " " << t << " " << vectors::traceEndWord(traces.ends[t]);
			for (std::size_t i = 0; i < path.size(); ++i)
			{
				const Vec3 exact = middle + alongHelix(path[0] - middle, traces.times[traces.first(t) + i]);
				ASSERT_LT(glm::length(path[i] - exact), 1e-4 * size) << block.name << " " << t << " " << i;
			}
			if (traces.ends[t] != TraceEnd::left_grid)
				continue;
			const Vec3 beyond = middle + alongHelix(path.back() - middle, 0.005);
			for (CellId c = 0; c < cellCount(block) && block.name != "three_on_a_face"; ++c) // whose cells overlap
			{
				locate::weighCell(block, c, beyond, weights);
				EXPECT_LT(weights.depth, 0.02) << block.name << " " << t << " " << c;
			}
		}
	}
}

} // namespace vp::test
