// --surface i=...: grid surfaces; --crinkle: whole cells.

#include "program.h"
#include "sample_files.h"

#include <numbers>

namespace cli
{

namespace
{

using nlohmann::json;

class Surface : public Program
{
protected:
	std::string image() const { return write("image.vtk", legacyImage()); }
	json sheet(const Arguments& options) const { return stats(options).at("sheets").at(0); }
	std::size_t lines(const std::string& name) const
	{
		const std::string text = contents(path(name));
		return static_cast<std::size_t>(std::ranges::count(text, '\n'));
	}
};

} // namespace

TEST_F(Surface, FiguresOfAPlainBox)
{
	const json cut = sheet({image(), "--surface", "k=1.25"});
	EXPECT_EQ(cut["surface"], "k=1.25");
	for (const char* key : {"origin", "normal", "up", "window", "crinkle"})
		EXPECT_TRUE(cut.contains(key) && cut[key].is_null()) << key;
	EXPECT_EQ(cut["cut_cells"], 9);
	EXPECT_EQ(cut["cells_touched"], 9);
	EXPECT_EQ(cut["polygons"], 9);
	EXPECT_EQ(cut["vertices"], 16);
	EXPECT_EQ(cut["components"], 1);
	EXPECT_NEAR(cut["area"], 9.0, 1e-12);
	for (const char* key : {"mean", "min", "max"})
		EXPECT_NEAR(cut[key], 1.25, 1e-6) << key; // height is z
	EXPECT_TRUE(sheet({image()})["surface"].is_null());
	// At a point cell arrays are those of the cells on the low side, at 0 those above.
	for (const auto& [index, mean] : {std::pair{"k=0", 104.0}, std::pair{"k=1", 104.0}, std::pair{"k=2", 113.0},
	                                  std::pair{"k=2.01", 122.0}, std::pair{"k=3", 122.0}})
		EXPECT_NEAR(sheet({image(), "--surface", index, "--array", "cell:both"})["mean"], mean, 1e-9) << index;
}

TEST_F(Surface, ASphereOfTheShell)
{
	const json cut = sheet({"demo:shell:32", "--surface", "i=12.5"});
	const double radius = 1.0 + 2.0 * 12.5 / 32.0;
	const double exact = radius * radius * 2.0 * std::numbers::pi * std::sin(0.45 * std::numbers::pi);
	EXPECT_NEAR(cut["area"].get<double>() / exact, 1.0, 2e-3);
	EXPECT_EQ(cut["cut_cells"], 32 * 32);
}

TEST_F(Surface, IsExported)
{
	const Arguments command{"slice", image(), "--surface", "j=1.5", "-o"};
	for (const char* name : {"out.vtp", "out.ply", "out.csv", "out.vtm"})
	{
		EXPECT_TRUE(isQuiet(run(command + Arguments{path(name)}))) << name;
		EXPECT_FALSE(contents(path(name)).empty()) << name;
	}
	EXPECT_EQ(lines("out.csv"), 1u + 4 * 9); // a row per corner
	EXPECT_TRUE(contains(contents(path("out.vtp")), "Name=\"wind\""));
	EXPECT_TRUE(contains(contents(path("out.vtp")), "vprobe:cell"));
}

TEST_F(Surface, HiddenCellsStayHidden)
{
	const std::string file = write("hidden.vti", imageWithHiddenCells());
	const auto quietly = [&](const char* at)
	{
		const Outcome outcome = run({"slice", file, "--surface", at, "--stats", "-"});
		EXPECT_EQ(outcome.status, 0) << outcome.err;
		return outcome.json().at("sheets").at(0);
	};
	EXPECT_EQ(quietly("k=0.5")["polygons"], 8);
	EXPECT_EQ(quietly("k=1")["polygons"], 8);
	EXPECT_EQ(quietly("k=2")["polygons"], 9); // the cell above shows there
	EXPECT_EQ(quietly("k=2.5")["polygons"], 9);
	EXPECT_EQ(quietly("i=1.5")["polygons"], 7);
}

TEST_F(Surface, NoDeviceIsNeeded)
{
	EXPECT_TRUE(isQuiet(run({"slice", "demo:shell:8", "--surface", "i=2"}, noDevice())));
}

TEST_F(Surface, ThresholdTurnsCellsDown)
{
	const json all = sheet({"demo:shell:16", "--surface", "i=4.5"});
	const json some = sheet({"demo:shell:16", "--surface", "i=4.5", "--threshold", "0.5", "2"});
	EXPECT_GT(some["cut_cells"], 0);
	EXPECT_LT(some["cut_cells"], all["cut_cells"]);
	EXPECT_TRUE(isDoneWithAWord(run({"slice", "demo:shell:16", "--surface", "i=4.5", "--threshold", "50", "60"}),
	                            {"empty", "--threshold"}));
}

TEST_F(Surface, WhatCannotBeIsOneLine)
{
	struct Case
	{
		const char* input;
		Arguments options;
		int status;
		std::vector<std::string> words;
	};
	for (const Case& wrong :
	     {Case{"demo:tets:6", {"--surface", "i=2"}, 2, {"--surface", "subscripts", "--normal"}},
	      Case{"demo:shell:8", {"--surface", "i=8.5"}, 1, {"--surface i=8.5", "0 to 8"}},
	      Case{"demo:shell:8", {"--surface", "k=-1"}, 1, {"--surface k=-1", "0 to 8"}},
	      Case{"demo:shell:8", {"--surface", "i=two"}, 1, {"--surface i=two"}},
	      Case{"demo:shell:8", {"--surface", "i="}, 1, {"--surface i="}},
	      Case{"demo:shell:8", {"--surface", "i=1..2"}, 1, {"--surface i=1..2", "sweep"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--window", "1", "1"}, 1, {"--window", "--surface"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--probe", "trihedral"}, 1, {"--probe", "--surface"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--normal", "x"}, 1, {"--normal", "--surface"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--origin", "0", "0", "0"}, 1, {"--origin", "--surface"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--seeds", "hotspot"}, 1, {"--seeds", "--surface"}},
	      Case{
	          "demo:shell:8", {"--surface", "i=2", "--visited", "octants"}, 1, {"--visited", "--surface i=2", "leave"}},
	      Case{"demo:shell:8", {"--surface", "i=2", "--visited", "stamps"}, 1, {"--visited", "--surface i=2"}}})
	{
		EXPECT_TRUE(isError(run(Arguments{"slice", wrong.input, "-o", path("out.vtp")} + wrong.options), wrong.status,
		                    wrong.words))
		    << wrong.options[1];
		EXPECT_TRUE(files().empty());
	}
}

TEST_F(Surface, FlatPicturesAndLinesAreOfPlanes)
{
	for (const Arguments& what : {Arguments{"--surface", "i=2"}, Arguments{"--crinkle"}})
	{
		EXPECT_TRUE(isError(run(Arguments{"slice", "demo:shell:8", "-o", path("a.png")} + what), 1, {what[0]}));
		EXPECT_TRUE(
		    isError(run(Arguments{"slice", "demo:shell:8", "--line", "0", "0", "1", "1", "-o", path("a.csv")} + what),
		            1, {what[0]}));
	}
	EXPECT_TRUE(files().empty());
}

TEST_F(Surface, IsSweptThroughItsRange)
{
	const Outcome swept =
	    run({"sweep", "demo:shell:8", "--surface", "i=0..8", "--frames", "5", "-o", path("out.pvd"), "--stats", "-"},
	        noDevice());
	ASSERT_EQ(swept.status, 0) << swept.err;
	const json frames = swept.json().at("frames");
	ASSERT_EQ(frames.size(), 5u);
	for (int f = 0; f < 5; ++f)
	{
		const json& cut = frames[static_cast<std::size_t>(f)]["sheets"][0];
		EXPECT_EQ(cut["surface"], "i=" + std::to_string(2 * f));
		const json alone = sheet({"demo:shell:8", "--surface", "i=" + std::to_string(2 * f)});
		EXPECT_EQ(cut["area"], alone["area"]);
	}
	EXPECT_TRUE(std::filesystem::exists(path("out.pvd")));
	const Outcome back = run({"sweep", "demo:shell:8", "--surface", "i=0..8", "--frames", "4", "--there-and-back", "-o",
	                          path("back.pvd"), "--stats", "-"},
	                         noDevice());
	EXPECT_EQ(back.json().at("frames").at(3).at("sheets").at(0).at("surface"), "i=4") << back.err;
}

TEST_F(Surface, ASweepThatCannotBeIsOneLine)
{
	const Arguments sweep{"sweep", "demo:shell:8", "--frames", "3", "-o", path("out.pvd")};
	EXPECT_TRUE(isError(run(sweep + Arguments{"--surface", "i=2"}, noDevice()), 1, {"--surface i=2", "i=0..2"}));
	EXPECT_TRUE(isError(run(sweep + Arguments{"--surface", "i=2..3", "--path", "spin"}, noDevice()), 1,
	                    {"--path spin", "--surface"}));
	EXPECT_TRUE(
	    isError(run(sweep + Arguments{"--surface", "i=2..3", "--path", "times"}, noDevice()), 1, {"--surface i=2..3"}));
	EXPECT_TRUE(isError(run(sweep + Arguments{"--surface", "i=2..9"}, noDevice()), 1, {"--surface i=2..9", "0 to 8"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Surface, CrinkleHoldsTheFacesOfTheWholeCells)
{
	const json plain = sheet({image()});
	const json cut = sheet({image(), "--crinkle"});
	for (const char* key : {"cut_cells", "polygons", "vertices", "area", "mean"})
		EXPECT_EQ(cut[key], plain[key]) << key;
	EXPECT_EQ(cut["crinkle"], (json{{"faces", 9 + 9 + 12}, {"vertices", 32}, {"area", 30.0}}));
	ASSERT_TRUE(isQuiet(run({"slice", image(), "--crinkle", "--classify", "cpu", "-o", path("out.csv")})));
	EXPECT_EQ(lines("out.csv"), 1u + 4 * 30);
	ASSERT_TRUE(isQuiet(run({"slice", image(), "--surface", "i=1.5", "--crinkle", "-o", path("layer.csv")})));
	EXPECT_EQ(lines("layer.csv"), 1u + 4 * 30);
}

TEST_F(Surface, IsKeptByAState)
{
	ASSERT_TRUE(isQuiet(run(
	    {"slice", "demo:shell:8", "--surface", "j=2.5", "--crinkle", "--save", path("a.json"), "-o", path("a.vtp")})));
	const json saved = json::parse(contents(path("a.json")));
	EXPECT_EQ(saved["probe"]["surface"], "j=2.5");
	EXPECT_EQ(saved["probe"]["crinkle"], true);
	ASSERT_TRUE(isQuiet(run({"slice", "--state", path("a.json"), "-o", path("b.vtp")})));
	EXPECT_EQ(contents(path("a.vtp")), contents(path("b.vtp")));
	EXPECT_TRUE(isError(run({"slice", "--state", path("a.json"), "--normal", "x"}), 1, {"--normal", "--surface"}));
}

TEST_F(Surface, OfTheBluntFin)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder";
	const json cut = sheet({std::string(data) + "/structured/bluntfin/bluntfinxyz.bin", "--surface", "i=12.5"});
	EXPECT_EQ(cut["cut_cells"], 31 * 31);
	EXPECT_EQ(cut["vertices"], 32 * 32);
	EXPECT_EQ(cut["components"], 1);
	EXPECT_EQ(cut["array"], "Density");
	EXPECT_GT(cut["min"], 0.0);
	EXPECT_LT(cut["max"], 10.0);
}

} // namespace cli
