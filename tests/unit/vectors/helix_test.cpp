#include "launched.h"

#include <gtest/gtest.h>

namespace vp::test
{

using vectors::Direction;
using vectors::TraceEnd;
using vectors::TraceOptions;
using vectors::Traces;

namespace
{

constexpr TestPlane kAskew{{0.3, 0.9, 0.1}, {0.3, 0.5, 0.81}};

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

} // namespace

TEST(Trace, FollowsTheHelixOnEveryDemo)
{
	for (const grid::Demo& demo_set : grid::demos())
	{
		const grid::BlockSet blocks = demo(demo_set.name, 12);
		const vectors::SheetLattice lattice = latticeOn(blocks, kAskew);
		ASSERT_GT(lattice.launches.size(), 50u) << demo_set.name;
		for (const double dt : {0.01, 0.3, 5.0})
		{
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

} // namespace vp::test
