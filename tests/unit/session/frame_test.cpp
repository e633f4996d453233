// A session takes from the frame before what has not changed, and finds the rest anew.
#include "session/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace vp::test
{

namespace
{

using session::Expect;
using session::FrameRequest;
using session::Session;
using SharedFrame = std::shared_ptr<const session::Frame>;

view::ViewSpec specOf(const std::string& input)
{
	view::ViewSpec spec;
	spec.input.files = {input};
	spec.machine.classify = view::Classify::cpu;
	return spec;
}

std::unique_ptr<Session> opened(const std::string& input, Expect expect = Expect::one_cut)
{
	return std::move(Session::open(specOf(input), {.expect = expect}).value());
}

SharedFrame frameOf(Session& session, FrameRequest request = {})
{
	return session.frame(request).value();
}

// An array u of every block that has one value at all points.
std::vector<std::vector<grid::Field>> constant(const Session& session, double value)
{
	std::vector<std::vector<grid::Field>> fields;
	for (const grid::Block& block : session.blocks().blocks)
	{
		const std::size_t points = std::visit([](const auto& grid) { return grid.pointCount(); }, block.grid);
		const std::vector<double> values(points, value);
		std::vector<std::byte> bytes(points * sizeof(double));
		std::memcpy(bytes.data(), values.data(), bytes.size());
		grid::Field field;
		field.name = "u";
		field.type = grid::NumberType::float64;
		field.bytes = Array<std::byte>(std::move(bytes));
		fields.push_back({field});
	}
	return fields;
}

} // namespace

TEST(SessionFrame, IsTheLastOneWhereNothingHasChanged)
{
	const auto session = opened("demo:shell:6");
	FrameRequest request{.expect = Expect::more};
	const SharedFrame first = frameOf(*session, request);
	request.last = first;
	EXPECT_EQ(frameOf(*session, request), first);

	view::ViewSpec other = session->spec(); // a matter of drawing
	other.look.symmetric = !other.look.symmetric;
	ASSERT_TRUE(session->set(other));
	EXPECT_EQ(frameOf(*session, request), first);

	other.look.contour.values = {0.0};
	ASSERT_TRUE(session->set(other));
	const SharedFrame with_contour = frameOf(*session, request);
	ASSERT_EQ(with_contour->contours.size(), 1u);
	EXPECT_EQ(with_contour->sheets[0].measure.area, first->sheets[0].measure.area);

	request.wants.figures = session::Wants::Figures::for_picture;
	EXPECT_NE(frameOf(*session, request), first);
}

TEST(SessionFrame, KeepsSheetsThatDidNotMove)
{
	view::ViewSpec spec = specOf("demo:shell:6");
	spec.probe.shape = view::ProbeShape::stack;
	spec.probe.offsets = {0.0, 0.1};
	const auto session = std::move(Session::open(spec, {}).value());
	FrameRequest request{.expect = Expect::more};
	request.last = frameOf(*session, request);
	spec.probe.offsets[1] = 0.2;
	ASSERT_TRUE(session->set(spec));
	const SharedFrame moved = frameOf(*session, request);
	EXPECT_EQ(moved->slice.sheets[0].number, request.last->slice.sheets[0].number);
	EXPECT_NE(moved->slice.sheets[1].number, request.last->slice.sheets[1].number);
	request.last.reset();
	const SharedFrame anew = frameOf(*session, request);
	for (std::size_t s = 0; s < 2; ++s)
		EXPECT_EQ(moved->sheets[s].measure.area, anew->sheets[s].measure.area);
}

// An array that is 3 everywhere, then 7.
TEST(SessionFrame, GathersNewValues)
{
	const auto session = opened("demo:tets:4", Expect::more);
	ASSERT_TRUE(session->replaceFields(constant(*session, 3.0)));
	FrameRequest request{.expect = Expect::more};
	request.last = frameOf(*session, request);
	EXPECT_NEAR(request.last->sheets[0].measure.mean.value(), 3.0, 1e-14);
	ASSERT_TRUE(session->replaceFields(constant(*session, 7.0)));
	const SharedFrame changed = frameOf(*session, request);
	EXPECT_NEAR(changed->sheets[0].measure.mean.value(), 7.0, 1e-14);
	EXPECT_EQ(changed->sheets[0].measure.area, request.last->sheets[0].measure.area);
}

TEST(SessionFrame, BuildsNeighborsForTheSecondCut)
{
	const auto session = opened("demo:tets:4");
	FrameRequest request;
	EXPECT_FALSE(session->needsNeighborsFor(request).value());
	request.last = frameOf(*session, request);
	EXPECT_FALSE(grid::hasNeighbors(session->blocks()));
	EXPECT_EQ(session->plan().value().sheets[0][0].strategy, find::Strategy::scan);

	request.expect = Expect::more;
	EXPECT_TRUE(session->needsNeighborsFor(request).value());
	const SharedFrame second = frameOf(*session, request);
	EXPECT_TRUE(grid::hasNeighbors(session->blocks()));
	EXPECT_EQ(session->plan().value().sheets[0][0].strategy, find::Strategy::cells);
	EXPECT_NE(second, request.last); // cells have other numbers now
	EXPECT_NEAR(second->sheets[0].measure.area, request.last->sheets[0].measure.area, 1e-12);
	EXPECT_FALSE(session->needsNeighborsFor(request).value());
}

// --visited and --color-by generation mean the same in every program.
TEST(SessionFrame, IsMadeByGenerationsWhereTheyAreAskedFor)
{
	const auto session = opened("demo:shell:6", Expect::more);
	const auto strategy = [&] { return session->plan().value().sheets[0][0].strategy; };
	EXPECT_EQ(strategy(), find::Strategy::spans);
	view::ViewSpec visited = session->spec();
	visited.machine.visited = find::VisitedSet::octants;
	ASSERT_TRUE(session->set(visited));
	EXPECT_EQ(strategy(), find::Strategy::generations);
	view::ViewSpec colored = specOf("demo:shell:6");
	colored.look.color_by = view::ColorBy::generation;
	ASSERT_TRUE(session->set(colored));
	EXPECT_EQ(strategy(), find::Strategy::generations);
	ASSERT_TRUE(session->set(specOf("demo:shell:6")));
	EXPECT_EQ(strategy(), find::Strategy::spans);
}

TEST(SessionFrame, SettingsThatFailFailAgain)
{
	const auto session = opened("demo:shell:6");
	view::ViewSpec wrong = session->spec();
	wrong.probe.array = "no such array";
	for (int i = 0; i < 2; ++i)
		EXPECT_FALSE(session->set(wrong));
	EXPECT_TRUE(session->set(specOf("demo:shell:6")));
	EXPECT_TRUE(session->frame({}));
}

// The pose of a request replaces that of the settings, which stay.
TEST(SessionFrame, StandsWhereTheRequestSays)
{
	const auto session = opened("demo:blob:5", Expect::more);
	const Box bounds = session->blocks().bounds();
	const Vec3 size = bounds.size();
	FrameRequest request{.expect = Expect::more};
	EXPECT_NEAR(frameOf(*session, request)->sheets[0].measure.area, size.x * size.y, 1e-9);
	request.pose = probe::makeFrame(bounds.center() + Vec3(0.01), {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
	EXPECT_NEAR(frameOf(*session, request)->sheets[0].measure.area, size.y * size.z, 1e-9);
	request.pose.reset();
	EXPECT_NEAR(frameOf(*session, request)->sheets[0].measure.area, size.x * size.y, 1e-9);
}

} // namespace vp::test
