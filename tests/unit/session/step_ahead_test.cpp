// Steps of time that are read before somebody asks for them have the values that their files have then.
#include "session/session.h"
#include "session/step_ahead.h"
#include "session/times_seen.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <stdlib.h>

namespace vp::test
{

namespace
{

namespace fs = std::filesystem;
using session::Session;

// Five images of eight points in a folder of their own. The values of a time are all the same.
class Steps : public testing::Test
{
protected:
	Steps()
	{
		std::string name = fs::temp_directory_path() / "vprobe-steps-XXXXXX";
		folder_ = mkdtemp(name.data());
		for (int step = 0; step < 5; ++step)
			write(step, 10.0 * step);
	}
	~Steps() override { fs::remove_all(folder_); }

	std::string file(int step) const { return folder_ / fmt::format("u_{}.vtk", step); }
	void write(int step, double value, int x = 0) const
	{
		std::ofstream out(file(step), std::ios::trunc);
		out << "# vtk DataFile Version 3.0\nu\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN " << x
		    << " 0 0\nSPACING 1 1 1\nPOINT_DATA 8\nSCALARS u double 1\nLOOKUP_TABLE default\n";
		for (int point = 0; point < 8; ++point)
			out << fmt::format("{:05.1f}\n", value); // so all files have one size
	}
	std::unique_ptr<Session> opened() const
	{
		view::ViewSpec spec;
		for (int step = 0; step < 5; ++step)
			spec.input.files.push_back(file(step));
		spec.input.inputs_as = read::InputsAs::times;
		spec.machine.classify = view::Classify::cpu;
		return std::move(Session::open(spec, {}).value());
	}

	fs::path folder_;
};

double valueOf(const Session& session)
{
	return grid::valueSpan(session.blocks().blocks[0].fields[0], 0).range().first;
}

double valueAt(Session& session, std::size_t step)
{
	const Status moved = session.goTo(read::timeAt(step));
	EXPECT_TRUE(moved) << moved.error().message;
	EXPECT_EQ(session.time(), double(step));
	return valueOf(session);
}

} // namespace

TEST(StepAhead, IsTheNextOneOfStepsInARow)
{
	session::StepAhead ahead;
	const auto next = [&](std::size_t step) { return ahead.nextAfter(step, 5); };
	const std::optional<std::size_t> none;
	EXPECT_EQ(next(0), none);
	EXPECT_EQ(next(1), 2u);
	EXPECT_EQ(next(2), 3u);
	EXPECT_EQ(next(4), none); // a jump
	EXPECT_EQ(next(3), 2u);   // backward
	EXPECT_EQ(next(3), none);
	EXPECT_EQ(next(4), none); // the last
	next(1);
	EXPECT_EQ(next(0), none); // the first
}

TEST_F(Steps, HaveTheirOwnValuesInAnyOrder)
{
	const auto session = opened();
	for (const std::size_t step : {0u, 1u, 2u, 3u, 4u, 3u, 2u, 1u, 0u, 1u, 2u, 4u, 0u, 3u, 3u, 2u, 1u, 4u})
		EXPECT_EQ(valueAt(*session, step), 10.0 * double(step));
}

TEST_F(Steps, HaveTheValuesOfTheirFilesWhenTheyAreAskedFor)
{
	const auto session = opened();
	valueAt(*session, 0);
	EXPECT_EQ(valueAt(*session, 1), 10.0);
	write(2, 77.0); // a reader may have begun with it
	EXPECT_EQ(valueAt(*session, 2), 77.0);
	fs::remove(file(3));
	const Status moved = session->goTo(read::timeAt(3));
	ASSERT_FALSE(moved);
	EXPECT_NE(moved.error().message.find("u_3.vtk"), std::string::npos) << moved.error().message;
	EXPECT_EQ(valueOf(*session), 77.0); // nothing has changed
	write(3, 5.0);
	EXPECT_EQ(valueAt(*session, 3), 5.0);
}

// Each step is read once, however it is asked for.
TEST_F(Steps, AreTakenFromWhatWasReadAhead)
{
	const auto session = opened();
	session::StepAhead ahead;
	const std::vector<double>& times = session->blocks().times;
	const auto isTaken = [&](const read::TimeChoice& time, const read::TimeChoice& expected = read::timeAt(2))
	{
		ahead.expect(session->inputs(), session->readOptions(expected), 2);
		return ahead.take(session->inputs(), session->readOptions(time), times).next().options.time == expected &&
		       !(time == expected);
	};
	using Kind = read::TimeChoice::Kind;
	EXPECT_TRUE(isTaken({Kind::value, 2.0}));
	EXPECT_TRUE(isTaken({Kind::value, 2.2}));
	EXPECT_TRUE(isTaken(read::timeAt(2), {Kind::value, 2.0}));
	EXPECT_FALSE(isTaken({Kind::value, 2.6}));
	EXPECT_FALSE(isTaken(read::timeAt(3)));
	EXPECT_FALSE(isTaken({Kind::first}));
	EXPECT_FALSE(isTaken({Kind::last}));

	const Status beyond = session->goTo(read::timeAt(7));
	ASSERT_FALSE(beyond);
	EXPECT_NE(beyond.error().message.find("#7"), std::string::npos) << beyond.error().message;
	for (const std::size_t step : {2u, 3u})
		valueAt(*session, step);
	EXPECT_FALSE(session->goTo(read::timeAt(7))); // while the last one is expected
}

TEST_F(Steps, OfAGridThatMovesAreReadAnew)
{
	write(3, 30.0, 4);
	const auto session = opened();
	for (const std::size_t step : {0u, 1u, 2u, 3u, 4u})
	{
		EXPECT_EQ(valueAt(*session, step), 10.0 * double(step));
		EXPECT_EQ(session->blocks().bounds().lo.x, step == 3 ? 4.0 : 0.0);
	}
}

TEST_F(Steps, AreAllSeen)
{
	write(2, -3.0, 4); // another grid, in the middle of those that are read ahead
	const auto session = opened();
	const std::vector<std::size_t> steps = {0, 1, 2, 3, 4};
	const std::vector<grid::FieldChoice> fields = {{"u", grid::Association::point, 0}};
	const auto seen = session::lookAtTimes(*session, steps, fields);
	ASSERT_TRUE(seen) << seen.error().message;
	ASSERT_EQ(seen->arrays.size(), 1u);
	EXPECT_EQ(seen->arrays[0].span.range(), std::pair(-3.0, 40.0));
	EXPECT_EQ(seen->arrays[0].least_positive, 10.0);
	EXPECT_EQ(seen->bounds.lo.x, 0.0);
	EXPECT_EQ(seen->bounds.hi.x, 5.0);
}

} // namespace vp::test
