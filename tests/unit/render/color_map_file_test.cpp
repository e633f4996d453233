#include "render/color/color_map_file.h"

#include "render/scene/value_style.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

namespace vp::render
{

namespace
{

ColorMap parsed(std::string_view text, const std::string& preset = {})
{
	auto made = parseColorMap(text, "map.json", preset);
	EXPECT_TRUE(made) << made.error().message;
	return made ? *made : ColorMap{};
}

testing::AssertionResult isNear(Color a, Color b, int tolerance = 1)
{
	const int off = std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
	return off <= tolerance ? testing::AssertionSuccess()
	                        : testing::AssertionFailure() << int(a.r) << " " << int(a.g) << " " << int(a.b) << " "
	                                                      << int(a.a) << " differs by " << off;
}

constexpr const char* kRedToBlue = R"("RGBPoints":[-1,1,0,0, 3,0,0,1])";

ColorMap inSpace(const std::string& space)
{
	return parsed(R"({"ColorSpace":")" + space + R"(",)" + kRedToBlue + "}");
}

} // namespace

TEST(ColorMapFile, PointsMakeAMap)
{
	const ColorMap map = parsed(
	    R"([{"Name":"traffic","ColorSpace":"RGB","NanColor":[0.2,0.4,0.6],
	         "RGBPoints":[10,0,1,0, 20,1,1,0, 50,1,0,0],
	         "BelowRangeColor":[0,0,0],"UseBelowRangeColor":1,"AboveRangeColor":[1,1,1],"UseAboveRangeColor":0}])");
	EXPECT_EQ(map.name, "traffic");
	EXPECT_EQ(map.at(0.0), (Color{0, 255, 0}));
	EXPECT_TRUE(isNear(map.at(0.25), {255, 255, 0}, 3)); // 20 of 10..50
	EXPECT_TRUE(isNear(map.at(0.625), {255, 128, 0}, 2));
	EXPECT_EQ(map.at(1.0), (Color{255, 0, 0}));
	EXPECT_EQ(map.nan, (Color{51, 102, 153}));
	EXPECT_EQ(map.below, (Color{0, 0, 0}));
	EXPECT_TRUE(map.marks_below);
	EXPECT_FALSE(map.marks_above); // so such values have the color of the high end
	EXPECT_EQ(map.above, makeColorMap("viridis")->above);
	EXPECT_TRUE(map.categories.empty());
}

// vtkColorTransferFunction's own colors half way from red to blue.
TEST(ColorMapFile, SpacesBetweenColors)
{
	EXPECT_TRUE(isNear(inSpace("RGB").at(0.5), {128, 0, 128}));
	EXPECT_TRUE(isNear(inSpace("HSV").at(0.5), {255, 0, 255}, 2));
	EXPECT_TRUE(isNear(inSpace("Lab").at(0.5), {202, 0, 136}, 3));
	EXPECT_TRUE(isNear(inSpace("Step").at(0.5), {0, 0, 255}));
	EXPECT_EQ(inSpace("Step").at(0.0), (Color{255, 0, 0}));
	// Between different hues a diverging map passes a pale gray.
	const Color middle = inSpace("Diverging").at(0.5);
	EXPECT_LE(std::max({middle.r, middle.g, middle.b}) - std::min({middle.r, middle.g, middle.b}), 6);
	EXPECT_GE(middle.g, 200);
	// And is our cool-warm for its ends.
	const ColorMap moreland = parsed(
	    R"({"ColorSpace":"Diverging","RGBPoints":[0,0.231373,0.298039,0.752941, 1,0.705882,0.0156863,0.14902]})");
	for (int i = 0; i < kColorMapSize; i += 15)
		EXPECT_TRUE(isNear(moreland.colors[i], makeColorMap("cool-warm")->colors[i], 1)) << i;
}

TEST(ColorMapFile, OpacitiesByValue)
{
	const std::string points = std::string("{") + kRedToBlue + R"(,"Points":[-1,0,0.5,0, 1,1,0.5,0, 3,0.5,0.5,0])";
	const ColorMap map = parsed(points + "}");
	EXPECT_EQ(map.at(0.0).a, 0);
	EXPECT_NEAR(map.at(0.25).a, 128, 2);
	EXPECT_NEAR(map.at(0.5).a, 255, 2);
	EXPECT_NEAR(map.at(0.75).a, 191, 2);
	EXPECT_EQ(parsed(points + R"(,"EnableOpacityMapping":false})").at(0.0).a, 255);
	// A midpoint off the middle, a step, and a smooth step: all pass 1/2 at the midpoint.
	for (const char* sharpness : {"0", "0.5", "1"})
	{
		const ColorMap shaped =
		    parsed(std::string("{") + kRedToBlue + R"(,"Points":[-1,0,0.25,)" + sharpness + ", 3,1,0.5,0]}");
		EXPECT_NEAR(shaped.at(0.25).a, 128, sharpness[0] == '1' ? 128 : 8) << sharpness;
		EXPECT_LE(shaped.at(0.2).a, 115) << sharpness;
		EXPECT_GE(shaped.at(0.4).a, 140) << sharpness;
	}
}

TEST(ColorMapFile, AnnotationsMakeCategories)
{
	const ColorMap map = parsed(R"({"IndexedColors":[1,0,0, 0,1,0],
	                                "Annotations":["3","three","-1.5","low","1e2",""]})");
	ASSERT_EQ(map.categories.size(), 3u);
	EXPECT_EQ(map.categories[0], (Category{-1.5, "low", {0, 255, 0}}));
	EXPECT_EQ(map.categories[1], (Category{3.0, "three", {255, 0, 0}}));
	EXPECT_EQ(map.categories[2], (Category{100.0, "100", {255, 0, 0}})); // colors in turn
	const ColorMap numbers = parsed(R"({"IndexedColors":[1,0,0, 0,1,0]})");
	EXPECT_EQ(numbers.categories[1], (Category{1.0, "1", {0, 255, 0}}));

	const CategorySteps steps = categorySteps(numbers);
	EXPECT_EQ(steps.bounds, (std::vector<double>{-0.5, 0.5, 1.5}));
	EXPECT_EQ(steps.colors, (std::vector<Color>{numbers.nan, {255, 0, 0}, {0, 255, 0}, numbers.nan}));
	EXPECT_EQ(categorySteps(map).bounds, (std::vector<double>{-2.0, -1.0, 2.5, 3.5, 99.5, 100.5}));
}

TEST(ColorMapFile, OneOfSeveralIsChosenByName)
{
	const std::string two = std::string(R"([{"Name":"a",)") + kRedToBlue + R"(},{"Name":"b",)" + kRedToBlue + "}]";
	EXPECT_EQ(parsed(two, "b").name, "b");
	const auto unnamed = parseColorMap(two, "map.json");
	ASSERT_FALSE(unnamed);
	EXPECT_NE(unnamed.error().message.find("a, b"), std::string::npos) << unnamed.error().message;
	EXPECT_FALSE(parseColorMap(two, "map.json", "c"));
}

TEST(ColorMapFile, ReversedMapsChangeTheirEnds)
{
	for (const std::string& name : colorMapNames())
	{
		const auto forward = chooseColorMap(name);
		const auto backward = chooseColorMap(name + "_r");
		ASSERT_TRUE(forward && backward) << name;
		EXPECT_EQ(forward->at(0.0), backward->at(1.0));
		EXPECT_EQ(forward->at(0.2), backward->at(0.8));
		EXPECT_EQ(forward->nan, backward->nan);
		EXPECT_EQ(backward->name, name + "_r");
	}
	ColorMap map;
	map.categories = {{0.0, "a", {1, 1, 1}}, {1.0, "b", {2, 2, 2}}, {2.0, "c", {3, 3, 3}}};
	const ColorMap other = reversed(map);
	EXPECT_EQ(other.categories[0], (Category{0.0, "a", {3, 3, 3}}));
	EXPECT_EQ(other.categories[1], (Category{1.0, "b", {2, 2, 2}}));
}

TEST(ColorMapFile, FilesOnDisk)
{
	const auto folder = std::filesystem::temp_directory_path() / "vprobe_color_map_file_test";
	std::filesystem::create_directories(folder);
	const std::string file = (folder / "my_r.json").string();
	std::ofstream(file) << R"([{"Name":"one",)" << kRedToBlue << R"(},{"Name":"two_r",)" << kRedToBlue << "}]";
	EXPECT_TRUE(chooseColorMap(file + ":one"));
	EXPECT_EQ(chooseColorMap(file + ":one_r")->at(0.0), (Color{0, 0, 255}));
	EXPECT_EQ(chooseColorMap(file + ":two_r")->at(0.0), (Color{255, 0, 0}));
	std::ofstream(file) << "{" << kRedToBlue << "}";
	EXPECT_EQ(chooseColorMap(file)->at(0.0), (Color{255, 0, 0}));
	EXPECT_EQ(chooseColorMap(file)->name, "my_r");
	EXPECT_EQ(chooseColorMap(file + "_r")->at(0.0), (Color{0, 0, 255}));
	std::filesystem::remove_all(folder);

	const auto missing = chooseColorMap(file);
	ASSERT_FALSE(missing);
	EXPECT_EQ(missing.error().kind, ErrorKind::input);
	EXPECT_NE(missing.error().message.find(file), std::string::npos);
	const auto unknown = chooseColorMap("jet_r");
	ASSERT_FALSE(unknown);
	EXPECT_EQ(unknown.error().kind, ErrorKind::usage);
	EXPECT_NE(unknown.error().message.find("jet_r"), std::string::npos);
}

TEST(ColorMapFile, WhatDoesNotServeIsToldInOneLine)
{
	struct Row
	{
		const char* text;
		const char* word;
	};
	for (const Row& row : {Row{"", "JSON"},
	                       {"RGBPoints", "JSON"},
	                       {"[]", "color map"},
	                       {"7", "color map"},
	                       {"[7]", "object"},
	                       {"{}", "RGBPoints"},
	                       {R"({"RGBPoints":7})", "RGBPoints"},
	                       {R"({"RGBPoints":[0,1,1,1]})", "RGBPoints"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1]})", "RGBPoints"},
	                       {R"({"RGBPoints":[0,1,1,1, "a",1,1,1]})", "RGBPoints"},
	                       {R"({"RGBPoints":[0,1,1,1, 0,1,1,1]})", "RGBPoints"},
	                       {R"({"RGBPoints":[1,1,1,1, 0,1,1,1]})", "ascending"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,2,1]})", "0 to 1"},
	                       {R"({"RGBPoints":[0,1,1,1, 1e999,1,1,1]})", "JSON"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"ColorSpace":"CMYK"})", "CMYK"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"ColorSpace":"a\nb"})", "a\\x0ab"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"Points":[0,1,0.5]})", "Points"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"Points":[0,7,0.5,0, 1,1,0.5,0]})", "Points"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"NanColor":[1,2]})", "NanColor"},
	                       {R"({"RGBPoints":[0,1,1,1, 1,1,1,1],"NanColor":[1,2,3]})", "NanColor"},
	                       {R"({"IndexedColors":[]})", "IndexedColors"},
	                       {R"({"IndexedColors":[1,0,0],"Annotations":["1"]})", "Annotations"},
	                       {R"({"IndexedColors":[1,0,0],"Annotations":{"1":"one"}})", "Annotations"},
	                       {R"({"IndexedColors":[1,0,0],"Annotations":["one","one"]})", "Annotations"},
	                       {R"({"IndexedColors":[1,0,0],"Annotations":["1","a","1","b"]})", "twice"},
	                       {"{\"Name\":\"a\nb\"}", "JSON"},
	                       {R"([{"Name":"a\nb"},{"Name":"c"}])", "choose"}})
	{
		const auto made = parseColorMap(row.text, "map.json");
		ASSERT_FALSE(made) << row.text;
		const std::string& message = made.error().message;
		EXPECT_EQ(made.error().kind, ErrorKind::input) << message;
		EXPECT_TRUE(message.starts_with("`colormap` map.json: ")) << message;
		EXPECT_NE(message.find(row.word), std::string::npos) << message;
		EXPECT_EQ(message.find('\n'), std::string::npos) << message;
	}
}

// As deep as the memory reaches, they would fill the stack.
TEST(ColorMapFile, NestedListsAreNone)
{
	const std::string open(2'000'000, '['), closed(2'000'000, ']');
	for (const std::string& text : {open, open + closed, "{\"RGBPoints\":" + open + closed + "}"})
		EXPECT_FALSE(parseColorMap(text, "map.json"));
}

} // namespace vp::render
