#include "render/color/opacity_points.h"

#include "render/color/color_map_file.h"
#include "render/color/preset_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::render
{

namespace
{

const OpacityPoints kHat{{0.2, 0.0}, {0.5, 0.8}, {0.5, 0.4}, {0.9, 1.0}};

ColorMap plainMap()
{
	return makeColorMap("cool-warm").value();
}

ColorMap readBack(const ColorMap& map, const OpacityPoints& points)
{
	auto read = parseColorMap(presetText(map, points), "map.json");
	EXPECT_TRUE(read) << read.error().message;
	return read.value();
}

} // namespace

TEST(OpacityPoints, AreLinearBetweenAndConstantBeyond)
{
	const ColorMap map = withOpacity(plainMap(), kHat);
	EXPECT_EQ(map.colors[0].a, 0);
	EXPECT_EQ(map.colors[51].a, 0);                                     // 51/255 = 0.2
	EXPECT_EQ(map.colors[102].a, std::lround(255.0 * 0.8 * 2.0 / 3.0)); // 0.4 is two thirds of the way to 0.5
	EXPECT_EQ(map.colors[127].a, std::lround(255.0 * 0.8 * (127.0 / 255.0 - 0.2) / 0.3));
	EXPECT_EQ(map.colors[128].a, std::lround(255.0 * (0.4 + 0.6 * (128.0 / 255.0 - 0.5) / 0.4))); // behind the jump
	EXPECT_EQ(map.colors[255].a, 255);
	EXPECT_EQ(map.colors[80].r, plainMap().colors[80].r);
	EXPECT_EQ(withOpacity(plainMap(), {}).colors, plainMap().colors);
}

TEST(OpacityPoints, ArePairsInOrder)
{
	EXPECT_EQ(opacityPoints(opacityNumbers(kHat)), kHat);
	EXPECT_EQ(whyNoOpacityPoints({}), "");
	EXPECT_EQ(whyNoOpacityPoints(opacityNumbers(kHat)), "");
	const auto refused = [](const std::vector<double>& numbers) { return !whyNoOpacityPoints(numbers).empty(); };
	EXPECT_TRUE(refused({0.0, 1.0}));
	EXPECT_TRUE(refused({0.0, 1.0, 0.5, 1.0, 1.0}));
	EXPECT_TRUE(refused({0.5, 1.0, 0.4, 1.0}));
	EXPECT_TRUE(refused(std::vector<double>(2 * kMaxOpacityPoints + 2, 0.5)));
	EXPECT_FALSE(refused(std::vector<double>(2 * kMaxOpacityPoints, 0.5)));
}

// The file of an edited map gives exactly its colors and opacities.
TEST(OpacityPoints, AreWrittenAsAPreset)
{
	for (const std::string& name : colorMapNames())
	{
		const ColorMap map = withOpacity(makeColorMap(name).value(), kHat);
		const ColorMap read = readBack(map, kHat);
		EXPECT_EQ(read.colors, map.colors) << name;
		EXPECT_EQ(read.name, name);
		EXPECT_EQ(read.nan, map.nan);
		EXPECT_EQ(readBack(map, {}).colors, map.colors) << name; // a point for each color
	}
	EXPECT_EQ(presetText(plainMap(), {}).find("\"Points\""), std::string::npos);
	ColorMap marked = plainMap();
	marked.marks_above = true;
	marked.above = {1, 2, 3};
	EXPECT_TRUE(readBack(marked, {}).marks_above);
	EXPECT_FALSE(readBack(marked, {}).marks_below);
	EXPECT_EQ(readBack(marked, {}).above, marked.above);
}

TEST(OpacityPoints, CategoriesAreWrittenToo)
{
	ColorMap map;
	map.name = "tissues";
	map.categories = {{-1.5, "air", {1, 2, 3}}, {2.0, "bone", {250, 240, 230}}};
	EXPECT_EQ(withOpacity(map, kHat).categories, map.categories);
	EXPECT_EQ(readBack(map, {}).categories, map.categories);
}

TEST(OpacityPoints, AreFoundInAMap)
{
	EXPECT_EQ(opacityPointsOf(plainMap()), (OpacityPoints{{0.0, 1.0}, {1.0, 1.0}}));
	const OpacityPoints ramp{{0.0, 0.0}, {0.4, 0.2}, {0.6, 1.0}, {1.0, 0.0}};
	const ColorMap map = withOpacity(plainMap(), ramp);
	const OpacityPoints found = opacityPointsOf(map);
	EXPECT_LE(found.size(), 2 * ramp.size());
	const auto expectNear = [](const ColorMap& a, const ColorMap& b, int levels)
	{
		for (int i = 0; i < kColorMapSize; ++i)
			EXPECT_LE(std::abs(a.colors[i].a - b.colors[i].a), levels) << i;
	};
	expectNear(withOpacity(plainMap(), found), map, 1);
	ColorMap wave = plainMap(); // so many corners that the points are fewer
	for (int i = 0; i < kColorMapSize; ++i)
		wave.colors[i].a = static_cast<std::uint8_t>(i % 8 < 4 ? 128 : 160);
	EXPECT_LE(opacityPointsOf(wave).size(), kMaxOpacityPoints);
	expectNear(withOpacity(plainMap(), opacityPointsOf(wave)), wave, 33);
}

TEST(OpacityPoints, AreEdited)
{
	OpacityPoints points{{0.0, 1.0}, {1.0, 1.0}};
	EXPECT_EQ(addPoint(points, {0.25, 0.5}), 1u);
	EXPECT_EQ(addBeside(points, 1), 2u);
	EXPECT_EQ(points[2], (OpacityPoint{0.625, 0.75}));
	EXPECT_EQ(addBeside(points, 3), 3u); // behind the last there is no room
	EXPECT_EQ(points[3], (OpacityPoint{0.8125, 0.875}));
	EXPECT_EQ(movePoint(points, 1, {0.9, -3.0}), 1u);
	EXPECT_EQ(points[1], (OpacityPoint{0.625, 0.0})); // up to its neighbor
	EXPECT_EQ(movePoint(points, 0, {-1.0, 0.5}), 0u);
	EXPECT_EQ(points[0], (OpacityPoint{0.0, 0.5}));
	EXPECT_EQ(removePoint(points, 4), 3u);
	EXPECT_EQ(removePoint(points, 1), 1u);
	EXPECT_EQ(removePoint(points, 0), 0u);
	EXPECT_EQ(removePoint(points, 0), 0u);
	EXPECT_EQ(points, (OpacityPoints{{0.625, 0.75}, {0.8125, 0.875}}));
	while (points.size() < kMaxOpacityPoints)
		addPoint(points, {0.9, 0.1});
	EXPECT_LT(addPoint(points, {1.0, 1.0}), points.size());
	EXPECT_EQ(points.size(), kMaxOpacityPoints);
}

} // namespace vp::render
