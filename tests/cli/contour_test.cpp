// --contour and its kin: surfaces of one value, grown from sheets.

#include "program.h"
#include "sample_files.h"

#include <algorithm>

namespace cli
{

namespace
{

using nlohmann::json;

const Arguments kSheet{"demo:blob:16", "--normal", "0.3 0.5 0.81", "--window", "3", "2"};

class Contour : public Program
{
protected:
	json contours(const Arguments& options) const { return stats(options).at("contours"); }
};

} // namespace

TEST_F(Contour, Figures)
{
	const json all = contours(kSheet + Arguments{"--contour", "0.2", "-0.4"});
	ASSERT_EQ(all.size(), 2u);
	EXPECT_EQ(all[0]["value"], 0.2);
	EXPECT_EQ(all[1]["value"], -0.4);
	for (const json& contour : all)
	{
		EXPECT_EQ(contour["sheet"], 0);
		EXPECT_GT(contour["area"], 0.1);
		EXPECT_GE(contour["polygons"], contour["cells"]);
		EXPECT_GE(contour["cells_touched"], contour["cells"]);
		EXPECT_GE(contour["components"], 1);
		EXPECT_GT(contour["generations"], 1);
	}
	EXPECT_TRUE(contours(kSheet).empty());
	EXPECT_GE(stats(kSheet + Arguments{"--contour", "0.2"}).at("ms").at("contour"), 0.0);
	// Every sheet has a contour.
	EXPECT_EQ(contours({"demo:blob:8", "--probe", "trihedral", "--contour", "0.2"}).size(), 3u);
}

TEST_F(Contour, OfAFieldThatIsLinearItIsAPlane)
{
	// height is z: across the sheet x = 1.5 lies a strip as wide as the box is deep, 3 by 1.5.
	const json all = contours({write("image.vtk", legacyImage()), "--normal", "x", "--contour", "1.25"});
	ASSERT_EQ(all.size(), 1u);
	EXPECT_NEAR(all[0]["area"], 3.0 * 1.5, 1e-6);
	EXPECT_EQ(all[0]["components"], 1);
	const json deep = contours({path("image.vtk"), "--normal", "x", "--contour", "1.25", "--contour-depth", "0.5"});
	EXPECT_NEAR(deep[0]["area"], 3.0 * 0.5, 1e-6);
}

TEST_F(Contour, AtAPlaceOfTheFirstSheet)
{
	const json all = contours({write("image.vtk", legacyImage()), "--probe", "stack", "--sheets", "2", "--normal", "x",
	                           "--up", "0", "0", "1", "--contour-at", "0.3", "0.75"});
	ASSERT_EQ(all.size(), 1u); // only the first sheet has one
	EXPECT_NEAR(all[0]["value"], 0.75 * 3.0, 1e-6);
	EXPECT_NEAR(contours({path("image.vtk"), "--normal", "x", "--up", "0", "0", "1", "--window", "1", "2",
	                      "--contour-at", "0.5", "0.25"})[0]["value"],
	            1.0, 1e-6);
	EXPECT_TRUE(
	    isError(run({"slice", "demo:shell:8", "--normal", "z", "--contour-at", "0.5", "0.05", "--classify", "cpu"}), 1,
	            {"--contour-at 0.5 0.05", "a place that it shows"}));
}

TEST_F(Contour, IsExportedWithTheSheet)
{
	const Arguments command = Arguments{"slice"} + kSheet + Arguments{"--contour", "0.2", "--classify", "cpu", "-o"};
	for (const char* name : {"out.vtp", "out.ply", "out.csv", "out.vtm"})
		EXPECT_TRUE(isQuiet(run(command + Arguments{path(name)}))) << name;
	for (const char* name : {"out.vtp", "out.ply", "out/sheet_0.vtp"})
		EXPECT_TRUE(contains(contents(path(name)), "vprobe:contour")) << name;
	const std::string table = contents(path("out.csv"));
	EXPECT_TRUE(contains(table.substr(0, table.find('\n')), ",contour"));
	EXPECT_TRUE(contains(table, ",nan\n"));
	EXPECT_TRUE(contains(table, ",0.2\n"));
	EXPECT_TRUE(isQuiet(run(Arguments{"slice"} + kSheet + Arguments{"--classify", "cpu", "-o", path("plain.vtp")})));
	EXPECT_FALSE(contains(contents(path("plain.vtp")), "vprobe:contour"));
}

TEST_F(Contour, WhatIsNotOnTheSheetIsTold)
{
	EXPECT_TRUE(isDoneWithAWord(
	    run(Arguments{"slice"} + kSheet + Arguments{"--contour", "7", "--classify", "cpu", "-o", path("out.vtp")}),
	    {"--contour 7 is empty", "has s from"}));
	EXPECT_TRUE(std::filesystem::exists(path("out.vtp")));
}

TEST_F(Contour, WhatCannotBe)
{
	const auto fails = [&](const Arguments& options, int status, const std::vector<std::string>& words) {
		EXPECT_TRUE(isError(run(Arguments{"slice", "--classify", "cpu"} + options), status, words));
	};
	fails({"demo:blob:4", "--contour", "nan"}, 1, {"--contour", "finite"});
	fails({"demo:blob:4", "--contour", "0", "--surface", "sphere:1"}, 1, {"--contour", "--surface sphere:1"});
	fails({"demo:blob:4", "--contour-at", "0", "0", "--iso", "0.5"}, 1, {"--contour-at", "--iso 0.5"});
	fails({"demo:shell:4", "--contour", "0", "--surface", "i=2"}, 1, {"--contour", "--surface i=2"});
	fails({write("image.vtk", legacyImage()), "--contour", "0", "--array", "cell:both"}, 2,
	      {"--contour", "both has them in cells", "--array"});
	for (const Arguments& bad : {Arguments{"--contour-depth", "-1"}, Arguments{"--contour-opacity", "1.5"},
	                             Arguments{"--contour-at", "0.5"}, Arguments{"--contour", "x"}})
		EXPECT_EQ(run(Arguments{"slice", "demo:blob:4", "--classify", "cpu"} + bad).status, 1) << bad[0];
}

TEST_F(Contour, StandsInAState)
{
	const Arguments given{"--contour", "0.2", "--contour-depth", "0.7", "--contour-opacity", "0.5"};
	const json figures = contours(kSheet + given + Arguments{"--save", path("a.json")});
	EXPECT_EQ(contours({"--state", path("a.json")}), figures);
	EXPECT_EQ(json::parse(contents(path("a.json"))).at("contours"),
	          json::parse(R"({"contour": [0.2], "contour_depth": 0.7, "contour_opacity": 0.5})"));
	EXPECT_NE(contours({"--state", path("a.json"), "--contour-depth", "0.2"}), figures);
}

} // namespace cli
