#include "render/color/color_map.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace vp::render
{

namespace
{

ColorMap map(std::string_view name)
{
	auto made = makeColorMap(name);
	EXPECT_TRUE(made);
	return *made;
}

int difference(Color a, Color b)
{
	return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

} // namespace

TEST(ColorMap, HasThePublishedColors)
{
	EXPECT_EQ(map("viridis").at(0.0), (Color{68, 1, 84}));
	EXPECT_EQ(map("viridis").colors[128], (Color{33, 145, 140}));
	EXPECT_EQ(map("viridis").at(1.0), (Color{253, 231, 37}));
	EXPECT_EQ(map("cividis").at(0.0), (Color{0, 34, 78}));
	EXPECT_EQ(map("cividis").colors[128], (Color{125, 124, 120}));
	EXPECT_EQ(map("cividis").at(1.0), (Color{254, 232, 56}));
	EXPECT_EQ(map("turbo").at(0.0), (Color{48, 18, 59}));
	EXPECT_EQ(map("turbo").colors[128], (Color{164, 252, 60}));
	EXPECT_EQ(map("turbo").at(1.0), (Color{122, 4, 3}));
	EXPECT_EQ(map("grey").at(0.0), (Color{0, 0, 0}));
	EXPECT_EQ(map("grey").colors[128], (Color{128, 128, 128}));
	EXPECT_EQ(map("grey").at(1.0), (Color{255, 255, 255}));
	// Moreland's table at 0, 1/4, 1/2, 3/4 and 1.
	const ColorMap diverging = map("cool-warm");
	EXPECT_LE(difference(diverging.at(0.0), {59, 76, 192}), 1);
	EXPECT_LE(difference(diverging.at(0.25), {141, 176, 254}), 2);
	EXPECT_LE(difference(diverging.at(0.5), {221, 221, 221}), 2);
	EXPECT_LE(difference(diverging.at(0.75), {244, 154, 123}), 2);
	EXPECT_LE(difference(diverging.at(1.0), {180, 4, 38}), 1);
}

TEST(ColorMap, EveryNameWorksAndNeighborsAreClose)
{
	for (const std::string& name : colorMapNames())
	{
		const ColorMap made = map(name);
		for (int i = 1; i < kColorMapSize; ++i)
			EXPECT_LE(difference(made.colors[i - 1], made.colors[i]), 8) << name << " " << i;
	}
}

TEST(ColorMap, ColorsOutsideTheRangeAreInNoMap)
{
	for (const std::string& name : colorMapNames())
	{
		const ColorMap made = map(name);
		for (const Color outside : {made.nan, made.below, made.above})
			for (const Color inside : made.colors)
				EXPECT_GE(difference(outside, inside), 20) << name;
		EXPECT_GE(difference(made.below, made.above), 40) << name;
		EXPECT_GE(difference(made.nan, made.above), 40) << name;
		EXPECT_GE(difference(made.nan, made.below), 40) << name;
	}
}

TEST(ColorMap, AnUnknownNameListsThoseThereAre)
{
	const auto made = makeColorMap("jet");
	ASSERT_FALSE(made);
	EXPECT_EQ(made.error().kind, ErrorKind::usage);
	EXPECT_NE(made.error().message.find("jet"), std::string::npos);
	for (const std::string& name : colorMapNames())
		EXPECT_NE(made.error().message.find(name), std::string::npos);
}

} // namespace vp::render
