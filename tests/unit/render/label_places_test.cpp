#include "render/annotate/label_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vp::render
{

namespace
{

const Area kPicture{glm::dvec2(0.0), {1000.0, 800.0}};
constexpr double kHeight = 12.0;
constexpr double kWidth = 30.0;

LabeledLine straight(const glm::dvec2& a, const glm::dvec2& b)
{
	LabeledLine line{{}, false, kWidth};
	for (int i = 0; i <= 50; ++i)
		line.points.push_back(glm::mix(a, b, i / 50.0));
	return line;
}

LabeledLine circle(const glm::dvec2& center, double radius)
{
	LabeledLine line{{}, true, kWidth};
	for (int i = 0; i < 90; ++i)
		line.points.push_back(
		    center + radius * glm::dvec2(std::cos(i * std::numbers::pi / 45.0), std::sin(i * std::numbers::pi / 45.0)));
	return line;
}

double lengthOf(const std::vector<glm::dvec2>& points)
{
	double length = 0.0;
	for (std::size_t i = 1; i < points.size(); ++i)
		length += glm::length(points[i] - points[i - 1]);
	return length;
}

// Returns true if two labels do not overlap, by the corners of their places.
bool apart(const LabelPlace& a, const LabelPlace& b)
{
	const double reach = glm::length(glm::dvec2(kWidth, kHeight));
	if (glm::length(a.center - b.center) > reach)
		return true;
	const auto axes = [](const LabelPlace& p)
	{
		return std::array{glm::dvec2(std::cos(p.angle), std::sin(p.angle)),
		                  glm::dvec2(-std::sin(p.angle), std::cos(p.angle))};
	};
	const auto extent = [&](const LabelPlace& p, const glm::dvec2& axis) {
		return 0.5 * kWidth * std::abs(glm::dot(axes(p)[0], axis)) +
		       0.5 * kHeight * std::abs(glm::dot(axes(p)[1], axis));
	};
	for (const LabelPlace* of : {&a, &b})
		for (const glm::dvec2& axis : axes(*of))
			if (std::abs(glm::dot(a.center - b.center, axis)) > extent(a, axis) + extent(b, axis))
				return true;
	return false;
}

} // namespace

TEST(LabelPlaces, LieOnTheirLinesAlongThem)
{
	for (const double degrees : {0.0, 30.0, 60.0, 90.0, 135.0, 180.0, 250.0, 270.0, 300.0})
	{
		SCOPED_TRACE(degrees);
		const double turn = degrees * std::numbers::pi / 180.0;
		const glm::dvec2 middle(500.0, 400.0);
		const glm::dvec2 along(std::cos(turn), std::sin(turn));
		const std::vector lines{straight(middle - 100.0 * along, middle + 100.0 * along)};
		const auto places = placeLabels(lines, kHeight, 1000.0, kPicture);
		ASSERT_EQ(places.size(), 1u);
		EXPECT_NEAR(std::abs(along.x * (places[0].center - middle).y - along.y * (places[0].center - middle).x), 0.0,
		            1e-9);
		EXPECT_NEAR(std::abs(std::cos(places[0].angle - turn)), 1.0, 1e-9); // either way along it
		EXPECT_GE(std::cos(places[0].angle), -1e-9);                        // never upside down
	}
	// Upright ones are read from below.
	const std::vector upright{straight({500.0, 100.0}, {500.0, 500.0})};
	EXPECT_NEAR(placeLabels(upright, kHeight, 1000.0, kPicture).at(0).angle, -0.5 * std::numbers::pi, 1e-9);
}

TEST(LabelPlaces, ShortLinesAndPlacesOutsideHaveNone)
{
	const auto count = [](const LabeledLine& line)
	{ return placeLabels(std::vector{line}, kHeight, 1000.0, kPicture).size(); };
	EXPECT_EQ(count(straight({100.0, 100.0}, {140.0, 100.0})), 0u);
	EXPECT_EQ(count(straight({100.0, 1100.0}, {900.0, 1100.0})), 0u);
	EXPECT_EQ(count(circle({500.0, 400.0}, 12.0)), 0u);
	EXPECT_EQ(count(circle({500.0, 400.0}, 100.0)), 1u);
	EXPECT_EQ(count({{{1.0, 1.0}}, false, kWidth}), 0u);
	EXPECT_EQ(count({{}, true, kWidth}), 0u);
	LabeledLine silent = straight({100.0, 100.0}, {900.0, 100.0});
	silent.width = 0.0;
	EXPECT_EQ(count(silent), 0u);
}

TEST(LabelPlaces, AreApartFromEachOther)
{
	std::vector<LabeledLine> lines;
	for (int i = 0; i < 40; ++i)
	{
		lines.push_back(straight({50.0, 20.0 + 19.0 * i}, {950.0, 780.0 - 11.0 * i}));
		lines.push_back(circle({300.0 + 9.0 * i, 400.0}, 20.0 + 8.0 * i));
	}
	const auto places = placeLabels(lines, kHeight, 200.0, kPicture);
	EXPECT_GT(places.size(), 10u);
	for (std::size_t i = 0; i < places.size(); ++i)
		for (std::size_t k = 0; k < i; ++k)
		{
			EXPECT_TRUE(apart(places[i], places[k]));
			EXPECT_TRUE(places[i].line != places[k].line || std::abs(places[i].from - places[k].from) >= 200.0);
		}
}

TEST(LabelPlaces, KeepOffWhatIsTakenAndWhatIsNotSeen)
{
	const std::vector lines{straight({100.0, 300.0}, {900.0, 300.0})};
	const std::vector taken{Area{{0.0, 200.0}, {700.0, 400.0}}};
	for (const LabelPlace& place : placeLabels(lines, kHeight, 50.0, kPicture, taken))
		EXPECT_GT(place.center.x - 0.5 * kWidth, 700.0);
	const auto left = [](std::size_t, const glm::dvec2& at) { return at.x < 250.0; };
	const auto places = placeLabels(lines, kHeight, 50.0, kPicture, {}, left);
	EXPECT_FALSE(places.empty());
	for (const LabelPlace& place : places)
		EXPECT_LT(place.center.x, 250.0);
	// A line without a label is kept off where there is room beside it.
	std::vector<LabeledLine> crossed = lines;
	for (double x = 100.0; x < 700.0; x += 10.0)
	{
		crossed.push_back(straight({x, 250.0}, {x, 350.0}));
		crossed.back().width = 0.0;
	}
	EXPECT_GT(placeLabels(crossed, kHeight, 1e4, kPicture).at(0).center.x, 700.0);
}

TEST(LabelPlaces, GapsTakeTheirPartOfTheLine)
{
	for (const LabeledLine& line : {straight({100.0, 300.0}, {900.0, 300.0}), circle({500.0, 400.0}, 120.0)})
	{
		const auto places = placeLabels(std::vector{line}, kHeight, 150.0, kPicture);
		ASSERT_FALSE(places.empty());
		std::vector<glm::dvec2> whole = line.points;
		if (line.closed)
			whole.push_back(whole.front());
		double rest = lengthOf(whole);
		for (const LabelPlace& place : places)
			rest -= place.to - place.from;
		double parts = 0.0;
		for (const auto& part : withGaps(line, places))
			parts += lengthOf(part);
		EXPECT_NEAR(parts, rest, 1e-9);
	}
}

// A sheet that comes near the eye has lines that are millions of times as long as the picture is wide.
TEST(LabelPlaces, TakeNoTimeForWhatIsOutside)
{
	std::vector<LabeledLine> lines{circle({500.0, 400.0}, 150.0), straight({-1e13, 401.0}, {1e13, 401.0}),
	                               straight({100.0, 1e14}, {100.0, -1e14})};
	const std::vector<LabelPlace> places = placeLabels(lines, kHeight, 300.0, kPicture);
	ASSERT_FALSE(places.empty());
	for (const LabelPlace& place : places)
	{
		EXPECT_EQ(place.line, 0u);
		EXPECT_GT(std::abs(place.center.y - 401.0), 0.5 * kHeight); // the long line is seen
	}
}

} // namespace vp::render
