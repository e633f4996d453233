#include "launched.h"
#include "tries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace vp::test
{

using vectors::TraceEnd;
using vectors::Traces;

namespace
{

// "w" over the points or cells of a block's source, as many as its other arrays have: any numbers, each its own; some
// not known.
void addRoughVectors(grid::Block& block, grid::Association association, std::mt19937& random)
{
	std::normal_distribution<double> any(0.0, 1.0);
	std::uniform_int_distribution<int> one_in(0, 99);
	const std::size_t count = std::ranges::find(block.fields, association, &grid::Field::association)->tuples();
	std::vector<double> values(3 * count);
	for (double& value : values)
		value = one_in(random) == 0 ? std::numeric_limits<double>::quiet_NaN() : any(random);
	block.fields.push_back(grid::makeField("w", association, 3, std::move(values)));
}

void expectSound(const Traces& traces, const grid::Block& block, double dt)
{
	const Vec3 slack(1e-6 * block.bounds.diagonal());
	for (std::size_t t = 0; t < traces.count(); ++t)
		for (std::size_t i = traces.first(t); i < traces.first(t) + traces.size(t); ++i)
		{
			const Vec3& p = traces.points[i];
			ASSERT_TRUE(glm::all(glm::greaterThanEqual(p, block.bounds.lo - slack))) << block.name << " " << t;
			ASSERT_TRUE(glm::all(glm::lessThanEqual(p, block.bounds.hi + slack))) << block.name << " " << t;
			ASSERT_LT(traces.cells[i], cellCount(block));
			if (i == traces.first(t))
				continue;
			ASSERT_GT(traces.times[i], traces.times[i - 1]) << block.name << " " << t;
			ASSERT_LT(traces.times[i] - traces.times[i - 1], dt * (1.0 + 1e-9));
		}
}

} // namespace

// Whatever the vectors are, paths stay in the grid, time goes on, and there is an end.
TEST(Trace, RoughVectorsOnEveryTestGrid)
{
	std::mt19937 random(41);
	for (const grid::Block& plain : allGrids())
		for (const grid::Association association : {grid::Association::point, grid::Association::cell})
		{
			grid::BlockSet blocks = setOf(plain);
			grid::Block& block = blocks.blocks[0];
			addRoughVectors(block, association, random);
			grid::matchInterfaces(blocks);
			std::vector<vectors::Launch> launches;
			for (CellId c = 0; c < cellCount(block); c += 3 * tryEvery())
				launches.push_back(
				    {std::visit([&](const auto& grid) { return cellCenter(grid, c); }, block.grid), 0, c, c});
			vectors::TraceOptions options;
			options.steps = 10.5;
			options.dt = 0.3 * block.bounds.diagonal();
			options.direction = vectors::Direction::both;
			expectSound(traced(blocks, launches, options, "w"), block, options.dt);
		}
}

} // namespace vp::test
