// --surface sphere:R, an expression …; --iso: sheets that are no planes.

#include "program.h"
#include "sample_files.h"

#include <numbers>

namespace cli
{

namespace
{

using nlohmann::json;

class CurvedSurface : public Program
{
protected:
	json sheet(const Arguments& options) const { return stats(options).at("sheets").at(0); }
};

constexpr double kPi = std::numbers::pi;

} // namespace

TEST_F(CurvedSurface, FiguresOfSolids)
{
	struct Solid
	{
		const char* surface;
		double area;
	};
	for (const Solid& solid :
	     {Solid{"sphere:2", 16.0 * kPi}, Solid{"cylinder:1.5", 3.0 * kPi * 6.0},
	      Solid{"x*x + y*y + z*z = 4", 16.0 * kPi}, Solid{"quadric:1,1,1,0,0,0,0,0,0,-4", 16.0 * kPi}})
	{
		const json cut = sheet({"demo:blob:32", "--surface", solid.surface});
		EXPECT_EQ(cut["surface"], solid.surface);
		EXPECT_NEAR(cut["area"].get<double>() / solid.area, 1.0, 0.01) << solid.surface;
		EXPECT_EQ(cut["components"], 1);
		EXPECT_GT(cut["tree_tests"], 0);
		EXPECT_GT(cut["generations"], 0);
	}
}

TEST_F(CurvedSurface, StandsWhereTheSheetStands)
{
	const json ball = sheet({"demo:blob:32", "--surface", "sphere:0.5", "--origin", "1", "0.5", "-1"});
	EXPECT_EQ(ball["origin"], json({1.0, 0.5, -1.0}));
	EXPECT_NEAR(ball["area"].get<double>() / kPi, 1.0, 0.05);
	// A cylinder along x through the whole box; and half of it in a window.
	const Arguments lying{"demo:blob:32", "--surface", "cylinder:1", "--normal", "x"};
	const json whole = sheet(lying);
	EXPECT_NEAR(whole["area"].get<double>(), 12.0 * kPi, 0.2);
	const json half = sheet(lying + Arguments{"--origin", "0", "0", "0", "--window", "6", "2"});
	EXPECT_GT(half["area"].get<double>(), 1.0);
	EXPECT_LE(half["area"].get<double>(), whole["area"].get<double>());
	// An expression is in the grid's coordinates, and in the sheet's where it is placed.
	EXPECT_NEAR(sheet({"demo:blob:32", "--surface", "z - 1"})["area"], 36.0, 1e-9);
	EXPECT_NEAR(sheet({"demo:blob:32", "--surface", "z - 1", "--normal", "1 0 0", "--origin", "0.5", "0", "0"})["area"],
	            36.0, 1e-9);
}

TEST_F(CurvedSurface, AStackIsARowOfThem)
{
	const json sheets =
	    stats({"demo:blob:24", "--probe", "stack", "--offsets", "-1", "1", "--surface", "sphere:0.6"}).at("sheets");
	ASSERT_EQ(sheets.size(), 2u);
	for (const json& ball : sheets)
		EXPECT_NEAR(ball["area"].get<double>() / (1.44 * kPi), 1.0, 0.05);
	EXPECT_EQ(sheets[0]["origin"][2], -1.0);
	EXPECT_EQ(sheets[1]["origin"][2], 1.0);
}

TEST_F(CurvedSurface, AProbeFileMixesThemWithPlanes)
{
	const std::string probe =
	    write("probe.json", R"({"sheets": [{"surface": "sphere:1"}, {}, {"surface": "iso:0.25", "array": "s"}]})");
	const json sheets = stats({"demo:blob:16", "--probe", probe}).at("sheets");
	ASSERT_EQ(sheets.size(), 3u);
	EXPECT_NEAR(sheets[0]["area"].get<double>() / (4.0 * kPi), 1.0, 0.05);
	EXPECT_TRUE(sheets[1]["surface"].is_null());
	EXPECT_NEAR(sheets[1]["area"], 36.0, 1e-9);
	EXPECT_NEAR(sheets[2]["mean"], 0.25, 1e-6);
	const std::string magnified =
	    write("fx.json", R"({"sheets": [{"surface": "sphere:1", "fx": {"magnification": 2}}]})");
	EXPECT_TRUE(isError(run({"slice", "demo:blob:8", "--probe", magnified}), 2, {"/sheets/0/surface", "fx"}));
	const std::string wrong = write("wrong.json", R"({"sheets": [{"surface": "sphere:0"}]})");
	EXPECT_TRUE(isError(run({"slice", "demo:blob:8", "--probe", wrong}), 2, {"/sheets/0/surface", "above 0"}));
}

TEST_F(CurvedSurface, IsoValues)
{
	const json iso = sheet({"demo:tets:12", "--iso", "0.25"});
	EXPECT_EQ(iso["surface"], "iso:0.25");
	EXPECT_GT(iso["cut_cells"], 100);
	for (const char* key : {"mean", "min", "max"})
		EXPECT_NEAR(iso[key], 0.25, 1e-6) << key;
	EXPECT_TRUE(isDoneWithAWord(run({"slice", "demo:tets:6", "--iso", "50"}), {"empty", "50", "go from"}));
	EXPECT_TRUE(isError(run({"slice", write("image.vtk", legacyImage()), "--iso", "1", "--array", "cell:both"}), 2,
	                    {"--iso 1", "points", "--array"}));
	EXPECT_TRUE(
	    isError(run({"slice", "demo:tets:6", "--iso", "1", "--surface", "sphere:1"}), 1, {"--iso", "--surface"}));
}

TEST_F(CurvedSurface, IsExportedWithItsArrays)
{
	EXPECT_TRUE(isQuiet(run({"slice", "demo:hexes:12", "--surface", "sphere:0.5", "--origin", "0", "2", "0",
	                         "--classify", "cpu", "-o", path("ball.vtp")})));
	const std::string text = contents(path("ball.vtp"));
	for (const char* word : {"<Polys>", "Name=\"s\"", "vprobe:cell"})
		EXPECT_TRUE(contains(text, word)) << word;
}

TEST_F(CurvedSurface, AStateKeepsIt)
{
	const std::string state = path("state.json");
	const json first = sheet({"demo:blob:16", "--surface", "x*x + y*y = 0.25*z", "--save", state});
	EXPECT_EQ(sheet({"--state", state}), first);
	const json iso = sheet({"--state", state, "--iso", "0.5"});
	EXPECT_EQ(iso["surface"], "iso:0.5");
}

TEST_F(CurvedSurface, OctantsFindTheSame)
{
	const Arguments cone{"demo:shell:16", "--surface", "cone:30"};
	const json stamps = sheet(cone);
	const json octants = sheet(cone + Arguments{"--visited", "octants"});
	for (const char* key : {"cut_cells", "polygons", "area", "generations", "cells_touched"})
		EXPECT_EQ(octants[key], stamps[key]) << key;
}

TEST_F(CurvedSurface, WhatCannotBeIsOneLine)
{
	struct Case
	{
		const char* surface;
		std::vector<std::string> words;
	};
	for (const Case& wrong : {Case{"sphere:-1", {"above 0"}}, Case{"cone:90", {"90 degrees"}},
	                          Case{"torus:1,2", {"no surface", "sphere:R"}}, Case{"x +", {"column"}},
	                          Case{"3 + 4", {"x, y"}}, Case{"x * width", {"column 5", "width"}}})
	{
		std::vector<std::string> words{std::string("--surface ") + wrong.surface};
		words.insert(words.end(), wrong.words.begin(), wrong.words.end());
		EXPECT_TRUE(isError(
		    run({"slice", "demo:blob:8", "--surface", wrong.surface, "--classify", "cpu", "-o", path("out.vtp")}), 1,
		    words))
		    << wrong.surface;
	}
	EXPECT_TRUE(isDoneWithAWord(run({"slice", "demo:blob:8", "--surface", "sphere:20", "--classify", "cpu"}),
	                            {"empty", "surface misses"}));
	EXPECT_TRUE(
	    isError(run({"slice", "demo:blob:8", "--surface", "sphere:1", "--classify", "cpu", "-o", path("a.png")}), 1,
	            {"--surface"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
