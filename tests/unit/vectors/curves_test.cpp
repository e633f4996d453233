#include "helix_traces.h"

#include "vectors/curves.h"

#include <gtest/gtest.h>

#include <limits>

namespace vp::test
{

namespace
{

using vectors::Curves;
using vectors::Traces;

Traces helix(double step, int before, int after)
{
	Traces traces;
	addHelix(traces, 2.0, step, before, after);
	return traces;
}

TEST(Curves, FollowTheExactPathBetweenWideSteps)
{
	const Traces traces = helix(0.5, 3, 8);
	const Curves curves = vectors::curvesOf(traces, traces.vectors);
	ASSERT_EQ(curves.count(), 1u);
	EXPECT_GT(curves.points.size(), 2 * traces.points.size());
	const std::vector<double> times = vectors::alongCurves(curves, traces.times);
	for (std::size_t i = 0; i < curves.points.size(); ++i)
	{
		const Vec3& p = curves.points[i];
		EXPECT_LT(glm::length(p - onHelix(2.0, times[i])), 1e-3) << i;
		const Vec3 along = glm::normalize(Vec3(-p.y, p.x, 0.3));
		EXPECT_GT(glm::dot(curves.directions[i], along), 1.0 - 1e-4) << i;
		EXPECT_TRUE(i == 0 || curves.points[i] != curves.points[i - 1]) << i;
	}
	EXPECT_EQ(curves.points.front(), traces.points.front());
	EXPECT_EQ(curves.points.back(), traces.points.back());
	EXPECT_EQ(curves.points[curves.launches[0]], traces.points[3]);
}

TEST(Curves, AreStraightWhereNothingBends)
{
	Traces traces = helix(0.1, 0, 1);
	traces.vectors[0] = traces.vectors[1] = traces.points[1] - traces.points[0];
	const Curves straight = vectors::curvesOf(traces, traces.vectors);
	EXPECT_EQ(straight.points.size(), 2u);
	// And where the velocity is not known.
	traces.vectors[0] = traces.vectors[1] = Vec3(std::numeric_limits<double>::quiet_NaN());
	EXPECT_EQ(vectors::curvesOf(traces, traces.vectors).points.size(), 2u);
}

TEST(Curves, LeaveOutTracesOfNoLengthAndPointsTwice)
{
	Traces traces = helix(0.5, 0, 0);
	addHelix(traces, 1.0, 0.5, 1, 1);
	addHelix(traces, 1.0, 0.0, 1, 1);
	traces.points[3] = traces.points[2]; // the second one's last lies on its launch
	const Curves curves = vectors::curvesOf(traces, traces.vectors);
	ASSERT_EQ(curves.count(), 1u);
	EXPECT_EQ(curves.points.front(), traces.points[1]);
	EXPECT_EQ(curves.points.back(), traces.points[2]);
	EXPECT_EQ(curves.launches[0], curves.points.size() - 1);
}

TEST(Curves, LeaveOutWhatIsTooNearToBeSeen)
{
	const Traces traces = helix(1e-4, 100, 100);
	const Curves all = vectors::curvesOf(traces, traces.vectors);
	EXPECT_EQ(all.points.size(), 201u);
	const Curves few = vectors::curvesOf(traces, traces.vectors, 0.01);
	EXPECT_LT(few.points.size(), 10u);
	EXPECT_EQ(few.points.front(), traces.points.front());
	EXPECT_EQ(few.points.back(), traces.points.back());
	EXPECT_EQ(few.points[few.launches[0]], traces.points[100]);
}

TEST(Curves, CarryADirectionAcrossThemWithoutTwist)
{
	Traces traces;
	addHelix(traces, 2.0, 0.4, 4, 12);
	for (Vec3& p : traces.points)
		p.z = 0.0; // a circle, whose normal stays where it is
	for (Vec3& v : traces.vectors)
		v.z = 0.0;
	const Curves circle = vectors::curvesOf(traces, traces.vectors);
	for (const Vec3& across : vectors::directionsAcross(circle, 0, {0.3, 0.0, 1.0}))
	{
		EXPECT_NEAR(across.z, std::sqrt(1.0 - 0.09 / 1.09), 1e-3);
		EXPECT_NEAR(glm::length(across), 1.0, 1e-12);
	}
	// Wished along the curve, or nowhere, it is still across.
	for (const Vec3& wished : {circle.directions[circle.launches[0]], Vec3(0.0)})
	{
		const std::vector<Vec3> across = vectors::directionsAcross(circle, 0, wished);
		ASSERT_EQ(across.size(), circle.points.size());
		for (std::size_t i = 0; i < across.size(); ++i)
			EXPECT_NEAR(glm::dot(across[i], circle.directions[i]), 0.0, 1e-12);
	}
}

} // namespace

} // namespace vp::test
