#include "launched.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace vp::test
{

using vectors::Direction;
using vectors::TraceEnd;
using vectors::TraceOptions;
using vectors::Traces;
using vectors::VectorPart;

namespace
{

Error errorOf(const TraceOptions& options)
{
	const grid::BlockSet blocks = demo("blob", 2);
	const vectors::Launch launch{Vec3(0.5), 0, 0, 0};
	return vectors::trace(blocks, vectors::chooseVectors(blocks, "v").value(), std::span(&launch, 1), options).error();
}

} // namespace

TEST(Trace, SameForAnyNumberOfThreads)
{
	for (const char* name : {"shell", "mixed"})
	{
		const grid::BlockSet blocks = demo(name, 10);
		const auto lattice = latticeOn(blocks, kAskew);
		const TraceOptions options = forTime(50, 0.07, Direction::both);
		const auto withThreads = [&](int threads)
		{
			const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
			return traced(blocks, lattice.launches, options);
		};
		const Traces alone = withThreads(1);
		const Traces many = withThreads(4);
		EXPECT_EQ(alone.starts, many.starts);
		EXPECT_TRUE(std::ranges::equal(alone.points, many.points));
		EXPECT_TRUE(std::ranges::equal(alone.times, many.times));
		EXPECT_EQ(alone.ends, many.ends);
		EXPECT_TRUE(std::ranges::equal(alone.cells, many.cells));
	}
}

// The slider from tuft to rake: an end moves as little as the steps do, over whole numbers too.
TEST(Trace, PartsOfStepsAreContinuous)
{
	const grid::BlockSet blocks = demo("mixed", 8);
	const auto lattice = latticeOn(blocks, kAskew, {8, 0.5});
	ASSERT_GT(lattice.launches.size(), 10u);
	constexpr double kDt = 0.2;
	Traces before = traced(blocks, lattice.launches, forTime(0.0, kDt));
	for (double steps = 0.05; steps < 3.2; steps += 0.05)
	{
		const Traces now = traced(blocks, lattice.launches, forTime(steps, kDt));
		for (std::size_t t = 0; t < now.count(); ++t)
		{
			const std::size_t end = now.starts[t + 1] - 1;
			const Vec3 moved = now.points[end] - before.points[before.starts[t + 1] - 1];
			const double speed = glm::length(now.vectors[end]);
			EXPECT_NEAR(glm::length(moved), now.ends[t] == TraceEnd::left_grid ? 0.0 : 0.05 * kDt * speed,
			            now.ends[t] == TraceEnd::left_grid ? 0.06 * kDt * speed : 0.002 * kDt * speed);
			EXPECT_LE(now.size(t), 1 + std::ceil(steps - 1e-6)) << steps;
		}
		before = now;
	}
}

TEST(Trace, NoStepsLeaveTheLaunch)
{
	const grid::BlockSet blocks = demo("tets", 6);
	const auto lattice = latticeOn(blocks, kAskew, {5, 0.0});
	const Traces traces = traced(blocks, lattice.launches, forTime(0.0, 1.0, Direction::both));
	ASSERT_EQ(traces.points.size(), lattice.launches.size());
	for (std::size_t t = 0; t < traces.count(); ++t)
	{
		EXPECT_EQ(traces.points[t], lattice.launches[t].position);
		EXPECT_EQ(traces.launches[t], t);
		EXPECT_EQ(traces.ends[t], TraceEnd::steps);
		EXPECT_EQ(traces.begins[t], TraceEnd::steps);
	}
}

TEST(Trace, BackwardComesFromWhereForwardGoes)
{
	const grid::BlockSet blocks = demo("shell", 10);
	const auto lattice = latticeOn(blocks, kAskew, {6, 0.0});
	const Traces back = traced(blocks, lattice.launches, forTime(5, 0.1, Direction::backward));
	const Traces both = traced(blocks, lattice.launches, forTime(5, 0.1, Direction::both));
	for (std::size_t t = 0; t < back.count(); ++t)
	{
		EXPECT_EQ(back.launches[t], back.starts[t + 1] - 1);
		EXPECT_EQ(back.ends[t], TraceEnd::steps);
		for (std::size_t i = 1; i < back.size(t); ++i)
			EXPECT_LT(back.times[back.first(t) + i - 1], back.times[back.first(t) + i]);
		EXPECT_EQ(back.path(t)[0], both.path(t)[0]);
	}
}

TEST(Trace, PartsOfTheVector)
{
	const grid::BlockSet blocks = demo("blob", 8);
	const auto lattice = latticeOn(blocks, kAskew, {6, 0.0});
	TraceOptions options = forTime(10, 0.1);
	options.normal = glm::normalize(kAskew.normal);
	options.part = VectorPart::tangential;
	const Traces in_sheet = traced(blocks, lattice.launches, options);
	for (std::size_t i = 0; i < in_sheet.points.size(); ++i)
	{
		EXPECT_NEAR(glm::dot(in_sheet.points[i] - kAskew.origin, options.normal), 0.0, 1e-9);
		const Vec3& p = in_sheet.points[i]; // the vector is told as it is
		EXPECT_LT(glm::length(in_sheet.vectors[i] - Vec3(-p.y, p.x, 0.3)), 1e-5);
	}
	options.part = VectorPart::normal;
	const Traces through = traced(blocks, lattice.launches, options);
	for (std::size_t t = 0; t < through.count(); ++t)
	{
		const Vec3 moved = through.path(t).back() - through.path(t).front();
		EXPECT_LT(glm::length(glm::cross(moved, options.normal)), 1e-9);
		EXPECT_GT(glm::length(moved), 0.0);
	}
}

TEST(Trace, BadOptionsAreToldWithTheRemedy)
{
	EXPECT_NE(errorOf(forTime(1, 0.0)).message.find("`vector_dt` 0: not a step; give"), std::string::npos);
	EXPECT_EQ(errorOf(forTime(1, 0.0)).kind, ErrorKind::usage);
	EXPECT_EQ(errorOf(forTime(1, NAN)).kind, ErrorKind::usage);
	EXPECT_EQ(errorOf(forTime(1, INFINITY)).kind, ErrorKind::usage);
	EXPECT_NE(errorOf(forTime(-1, 0.1)).message.find("`vector_steps` -1"), std::string::npos);
	EXPECT_NE(errorOf(forTime(1e10, 0.1)).message.find("take fewer steps"), std::string::npos);
}

TEST(Trace, EndsWhenAskedTo)
{
	const grid::BlockSet blocks = demo("blob", 4);
	const auto lattice = latticeOn(blocks, kAskew);
	std::stop_source stop;
	stop.request_stop();
	const Result<Traces> traces = vectors::trace(blocks, vectors::chooseVectors(blocks, "v").value(), lattice.launches,
	                                             forTime(5, 0.1), stop.get_token());
	ASSERT_FALSE(traces);
	EXPECT_EQ(traces.error().kind, ErrorKind::cancelled);
}

TEST(ChooseVectors, TakesArraysOfThreeComponents)
{
	grid::BlockSet blocks = demo("blob", 2);
	EXPECT_EQ(vectors::chooseVectors(blocks, "")->name, "v");
	EXPECT_EQ(vectors::chooseVectors(blocks, "point:v")->association, grid::Association::point);
	const Error scalar = vectors::chooseVectors(blocks, "s").error();
	EXPECT_EQ(scalar.kind, ErrorKind::input);
	EXPECT_EQ(scalar.message, "`vector_array` s: has 1 component, a vector has three; arrays of three: point:v");
	EXPECT_NE(vectors::chooseVectors(blocks, "w").error().message.find("no such array; arrays of three"),
	          std::string::npos);
	blocks.blocks[0].fields.clear();
	EXPECT_NE(vectors::chooseVectors(blocks, "").error().message.find("no array of three"), std::string::npos);
	blocks.blocks[0].fields.push_back(
	    grid::makeField("c", grid::Association::cell, 3, std::vector<double>(3 * 8, 1.0)));
	EXPECT_EQ(vectors::chooseVectors(blocks, "")->association, grid::Association::cell);
}

} // namespace vp::test
