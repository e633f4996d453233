#include "launched.h"
#include "vectors/path_lines.h"

#include <gtest/gtest.h>

namespace vp::test
{

using vectors::Direction;
using vectors::TraceEnd;
using vectors::TraceOptions;
using vectors::Traces;

namespace
{

// At time t the vector (1, t, 0) over a box of -3..3: linear in time, so a path is a parabola.
struct Moving
{
	grid::BlockSet blocks = demo("blob", 12);
	std::vector<std::size_t> loaded;
	vectors::StoredVectors stored;

	Moving()
	{
		stored.times = {0.0, 0.5, 0.8, 2.0};
		stored.load = [this](std::size_t index) -> Result<std::vector<grid::Field>>
		{
			loaded.push_back(index);
			std::vector<double> values;
			for (std::size_t p = 0; p < blocks.pointCount(); ++p)
				values.insert(values.end(), {1.0, stored.times[index], 0.0});
			return std::vector{grid::makeField("v", grid::Association::point, 3, std::move(values))};
		};
	}
	Traces lines(double launch_time, const TraceOptions& options)
	{
		const Vec3 from(0.1, 0.2, 0.3);
		const vectors::Launch launch{from, 0, locate::findCell(blocks.blocks[0], kNoCell, from).cell, 0};
		return vectors::tracePathLines(blocks, stored, launch_time, std::span(&launch, 1), options).value();
	}
};

} // namespace

TEST(PathLines, FollowVectorsThatChange)
{
	Moving moving;
	constexpr double kLaunch = 0.6;
	const Traces traces = moving.lines(kLaunch, forTime(5, 0.2, Direction::both));
	ASSERT_EQ(traces.ends[0], TraceEnd::steps);
	EXPECT_EQ(traces.begins[0], TraceEnd::no_vector);
	EXPECT_NEAR(traces.times.front(), -kLaunch, 1e-12);
	ASSERT_EQ(traces.points.size(), 3u + 1u + 5u); // -0.6 ends the third step back
	for (std::size_t i = 0; i < traces.points.size(); ++i)
	{
		const double t = kLaunch + traces.times[i];
		const Vec3 exact(0.1 + traces.times[i], 0.2 + 0.5 * (t * t - kLaunch * kLaunch), 0.3);
		EXPECT_LT(glm::length(traces.points[i] - exact), 1e-6) << t;
		EXPECT_NEAR(traces.vectors[i].y, t, 1e-9);
	}
	// Back from the pair that holds the launch, then on from it; each once in either direction.
	EXPECT_EQ(moving.loaded, (std::vector<std::size_t>{2, 1, 0, 1, 2, 3}));
}

TEST(PathLines, EndWithTheStoredTimes)
{
	Moving moving;
	const Traces on = moving.lines(1.9, forTime(50, 0.03, Direction::forward));
	EXPECT_EQ(on.ends[0], TraceEnd::no_vector);
	EXPECT_NEAR(on.times.back(), 0.1, 1e-12);
	for (const double end : {0.0, 2.0})
	{
		const Traces at_end = moving.lines(end, forTime(3, 0.1, end == 0.0 ? Direction::backward : Direction::forward));
		EXPECT_EQ(at_end.points.size(), 1u);
		EXPECT_NEAR(at_end.vectors[0].y, end, 1e-12);
	}
	const Result<Traces> late =
	    vectors::tracePathLines(moving.blocks, moving.stored, 2.1, {}, forTime(1, 1, Direction::forward));
	ASSERT_FALSE(late);
	EXPECT_EQ(late.error().kind, ErrorKind::usage);
	EXPECT_NE(late.error().message.find("give 0 to 2"), std::string::npos);
}

TEST(PathLines, WaitWhereNothingMovesForAWhile)
{
	Moving moving;
	const auto load = moving.stored.load;
	moving.stored.load = [&](std::size_t index)
	{
		Result<std::vector<grid::Field>> fields = load(index);
		if (index < 2)
			*fields = {grid::makeField("v", grid::Association::point, 3,
			                           std::vector<double>(3 * moving.blocks.pointCount(), 0.0))};
		return fields;
	};
	const Traces traces = moving.lines(0.1, forTime(10, 0.1, Direction::forward));
	EXPECT_EQ(traces.ends[0], TraceEnd::steps);
	EXPECT_EQ(traces.points[4], traces.points[0]);
	EXPECT_GT(traces.points[10].x, 0.2);
}

TEST(PathLines, AFailureToLoadIsHandedOn)
{
	Moving moving;
	moving.stored.load = [](std::size_t) -> Result<std::vector<grid::Field>> {
		return Error{ErrorKind::input, "gone"};
	};
	const vectors::Launch launch{Vec3(0.1), 0, 0, 0};
	const Result<Traces> traces = vectors::tracePathLines(moving.blocks, moving.stored, 0.1, std::span(&launch, 1),
	                                                      forTime(1, 1, Direction::forward));
	ASSERT_FALSE(traces);
	EXPECT_EQ(traces.error().message, "gone");
}

} // namespace vp::test
