#include "program.h"
#include "sample_files.h"

namespace cli
{

namespace
{

class Slice : public Program
{
protected:
	std::string image() const { return write("image.vtk", legacyImage()); }
	double mean(const Arguments& options) const
	{
		return stats(Arguments{image()} + options)["sheets"][0]["mean"].get<double>();
	}
};

} // namespace

TEST_F(Slice, StatsKeepTheirKeys)
{
	const nlohmann::json all = stats({"demo:shell:16"});
	for (const char* key : {"input", "grid", "device", "classifier", "sheets", "ms"})
		EXPECT_TRUE(all.contains(key)) << key;
	for (const char* key : {"kind", "cells", "points", "blocks"})
		EXPECT_TRUE(all["grid"].contains(key)) << key;
	ASSERT_EQ(all["sheets"].size(), 1u);
	for (const char* key :
	     {"origin",        "normal",        "cut_cells",     "polygons",      "vertices",       "components",
	      "area",          "mean",          "min",           "max",           "seeds",          "hops",
	      "generations",   "front_max",     "cells_touched", "cells_twisted", "boundary_faces", "boundary_area",
	      "boundary_mean", "boundary_flux", "flux",          "nan_area"})
		EXPECT_TRUE(all["sheets"][0].contains(key)) << key;
	for (const char* key :
	     {"read", "build", "upload", "seed", "traverse", "gpu", "emit", "readback", "render", "total"})
		EXPECT_TRUE(all["ms"].contains(key) && all["ms"][key].is_number()) << key;
	EXPECT_EQ(all["input"], "demo:shell:16");
	EXPECT_EQ(all["classifier"], "cpu");
	EXPECT_EQ(all["grid"]["cells"], 4096);
}

TEST_F(Slice, CountsOfAPlainBox)
{
	const nlohmann::json sheet = stats({image()})["sheets"][0];
	EXPECT_EQ(sheet["origin"], (nlohmann::json{1.5, 1.5, 1.5}));
	EXPECT_EQ(sheet["normal"], (nlohmann::json{0.0, 0.0, 1.0}));
	EXPECT_EQ(sheet["cut_cells"], 9);
	EXPECT_EQ(sheet["polygons"], 9);
	EXPECT_EQ(sheet["vertices"], 16);
	EXPECT_EQ(sheet["components"], 1);
	EXPECT_NEAR(sheet["area"], 9.0, 1e-6);
	EXPECT_NEAR(sheet["mean"], 1.5, 1e-6);
	EXPECT_NEAR(sheet["min"], 1.5, 1e-6);
	EXPECT_NEAR(sheet["max"], 1.5, 1e-6);
}

// The image's lower side: what would be cut lies above it alone.
TEST_F(Slice, InTheBoundary)
{
	const Arguments low{image(), "--origin", "1.5", "1.5", "0", "--array", "point:both", "--vector-array", "wind"};
	const Arguments high{image(), "--origin", "1.5", "1.5", "3", "--array", "point:both", "--vector-array", "wind"};
	const Outcome told = run(Arguments{"slice"} + low + Arguments{"--classify", "cpu", "--stats", "-"});
	EXPECT_EQ(told.status, 0);
	EXPECT_TRUE(contains(told.err, "lies in the boundary") && contains(told.err, "area is 0")) << told.err;
	const nlohmann::json below = told.json()["sheets"][0];
	const nlohmann::json above = stats(high)["sheets"][0];
	EXPECT_EQ(below["area"], 0.0);
	EXPECT_NEAR(below["boundary_area"], 9.0, 1e-12);
	EXPECT_NEAR(below["boundary_mean"], 1.5, 1e-12);
	EXPECT_NEAR(below["boundary_flux"], 18.0, 1e-12);
	EXPECT_EQ(below["flux"], 0.0);
	EXPECT_TRUE(below["mean"].is_null());
	EXPECT_NEAR(above["area"], 9.0, 1e-12);
	EXPECT_NEAR(above["mean"], 1.5, 1e-12);
	EXPECT_NEAR(above["flux"], 18.0, 1e-12);
	EXPECT_EQ(above["boundary_area"], 0.0);
	EXPECT_EQ(above["boundary_flux"], 0.0);
	EXPECT_TRUE(above["boundary_mean"].is_null());

	const Outcome table = run(Arguments{"slice"} + low + Arguments{"--classify", "cpu"});
	for (const char* title : {"boundary area", "boundary mean", "boundary flux", " 18\n"})
		EXPECT_TRUE(contains(table.out, title)) << title << " in " << table.out;
	EXPECT_FALSE(contains(run(Arguments{"slice"} + high + Arguments{"--classify", "cpu"}).out, "boundary"));
}

TEST_F(Slice, FramesInTheBoundaryAreTold)
{
	const Outcome swept = run({"sweep", image(), "--path", "rotate", "--origin", "1.5", "1.5", "0", "--frames", "4",
	                           "--stats", "-", "-o", path("out.pvd"), "--vector-array", "wind", "--classify", "cpu"});
	ASSERT_EQ(swept.status, 0) << swept.err;
	const nlohmann::json first = swept.json()["frames"][0]["sheets"][0];
	EXPECT_NEAR(first["boundary_flux"], 18.0, 1e-12);
	EXPECT_TRUE(contains(swept.err, "in 2 of 4 frames")) << swept.err; // the first, and that turned halfway round
}

TEST_F(Slice, ArrayByNameAndAssociation)
{
	EXPECT_NEAR(mean({}), 1.5, 1e-6); // the first point array, though cell arrays come first in the file
	EXPECT_NEAR(mean({"--array", "point:both"}), 1.5, 1e-6);
	EXPECT_NEAR(mean({"--array", "cell:both"}), 113.0, 1e-4);
	EXPECT_NEAR(mean({"--array", "mass"}), 7.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "cell:mass"}), 7.0, 1e-6);
}

TEST_F(Slice, Component)
{
	EXPECT_NEAR(mean({"--array", "wind"}), 3.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "wind", "--component", "magnitude"}), 3.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "wind", "--component", "x"}), 1.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "wind", "--component", "y"}), 2.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "wind", "--component", "0"}), 1.0, 1e-6);
	EXPECT_NEAR(mean({"--array", "wind", "--component", "2"}), 2.0, 1e-6);
}

TEST_F(Slice, NormalByLetterOrNumbers)
{
	for (const char* letter : {"x", "y", "z"})
	{
		const Arguments numbers{letter[0] == 'x' ? "2" : "0", letter[0] == 'y' ? "2" : "0",
		                        letter[0] == 'z' ? "2" : "0"};
		const nlohmann::json by_letter = stats({image(), "--normal", letter})["sheets"][0];
		const nlohmann::json by_numbers = stats(Arguments{image(), "--normal"} + numbers)["sheets"][0];
		EXPECT_EQ(by_letter["normal"], by_numbers["normal"]) << letter;
		EXPECT_EQ(by_letter["cut_cells"], 9) << letter;
	}
	// Negative numbers are values, not options.
	EXPECT_EQ(stats({image(), "--normal", "-1", "-0.5", "-.25", "--origin", "1.4", "+1.5", "1.5e0"})["sheets"].size(),
	          1u);
}

TEST_F(Slice, InputAfterTheOptions)
{
	EXPECT_EQ(stats({"--normal", "0", "0", "1", image()})["sheets"][0]["cut_cells"], 9);
	EXPECT_EQ(stats({"--normal", "z", image()})["sheets"][0]["cut_cells"], 9);
	EXPECT_EQ(stats({"--origin", "1.5", "1.5", "1.5", image()})["sheets"][0]["cut_cells"], 9);
	EXPECT_EQ(stats({"--normal=z", image()})["sheets"][0]["cut_cells"], 9);
}

TEST_F(Slice, SeedsAndOutside)
{
	for (const char* seeds : {"auto", "hotspot", "boundary"})
		EXPECT_EQ(stats({image(), "--seeds", seeds})["sheets"][0]["cut_cells"], 9) << seeds;
	for (const char* outside : {"nearest", "refuse", "report"})
		EXPECT_EQ(stats({image(), "--outside", outside})["sheets"][0]["cut_cells"], 9) << outside;
}

TEST_F(Slice, HotSpotOutsideTheGrid)
{
	const Arguments probe{"slice", image(), "--origin",      "10",       "1.5", "1.5", "--classify",
	                      "cpu",   "-o",    path("out.vtp"), "--outside"};
	EXPECT_TRUE(isError(run(probe + Arguments{"refuse"}), 1, {"--origin", "--outside"}));
	EXPECT_FALSE(std::filesystem::exists(path("out.vtp")));
	EXPECT_TRUE(isDoneWithAWord(run(probe + Arguments{"report"}), {"--origin"}));
	EXPECT_TRUE(isDoneWithAWord(run(probe + Arguments{"nearest", "--seeds", "hotspot"}), {"--origin"}));
	// The plane is the same one, and whole, wherever the search begins.
	EXPECT_EQ(stats({image(), "--origin", "10", "1.5", "1.5"})["sheets"][0]["cut_cells"], 9);
}

TEST_F(Slice, Time)
{
	for (const char* time : {"last", "first", "0", "1.5", "#0"})
		EXPECT_EQ(stats({image(), "--time", time})["sheets"][0]["cut_cells"], 9) << time;
}

TEST_F(Slice, ThreadsChangeNothing)
{
	const nlohmann::json one = stats({"demo:mixed:8", "--normal", "1", "2", "3", "--threads", "1"})["sheets"][0];
	const nlohmann::json two = stats({"demo:mixed:8", "--normal", "1", "2", "3", "--threads", "2"})["sheets"][0];
	for (const char* key : {"cut_cells", "polygons", "vertices", "components", "area"})
		EXPECT_EQ(one[key], two[key]) << key;
}

TEST_F(Slice, VisitedAsksForGenerations)
{
	const Arguments plane = {"demo:shell:16", "--normal", "0.3", "0.5", "0.81"};
	const nlohmann::json found = stats(plane)["sheets"][0];
	const nlohmann::json stamps = stats(plane + Arguments{"--visited", "stamps"})["sheets"][0];
	const nlohmann::json octants = stats(plane + Arguments{"--visited", "octants"})["sheets"][0];
	EXPECT_EQ(found["generations"], 0);
	EXPECT_GT(stamps["generations"], 1);
	EXPECT_EQ(octants, stamps);
	for (const char* key : {"cut_cells", "polygons", "vertices"})
		EXPECT_EQ(stamps[key], found[key]) << key;
}

TEST_F(Slice, WithoutAnArray)
{
	std::string bare = legacyImage();
	bare.resize(bare.find("CELL_DATA"));
	const Outcome outcome = run({"slice", write("bare.vtk", bare), "--classify", "cpu", "--stats", "-"});
	ASSERT_EQ(outcome.status, 0) << outcome.err;
	const nlohmann::json sheet = outcome.json()["sheets"][0];
	EXPECT_EQ(sheet["cut_cells"], 9);
	for (const char* key : {"mean", "min", "max"})
		EXPECT_TRUE(sheet[key].is_null()) << key;
}

TEST_F(Slice, TableWhenNothingIsToBeWritten)
{
	const Outcome outcome = run({"slice", image(), "--classify", "cpu"});
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_FALSE(outcome.out.empty());
	EXPECT_FALSE(outcome.out.front() == '{');
	EXPECT_TRUE(contains(outcome.out, "9"));
}

TEST_F(Slice, StrictTakesWarningsForFailures)
{
	const Arguments beside{"slice", image(),   "--origin",         "100",     "0", "0", "--normal", "x", "--classify",
	                       "cpu",   "--stats", path("stats.json"), "--strict"};
	const Outcome outcome = run(beside);
	EXPECT_EQ(outcome.status, 6);
	EXPECT_TRUE(contains(outcome.err, "vprobe: warning: ") && contains(outcome.err, "--strict: ")) << outcome.err;
	EXPECT_FALSE(contents(path("stats.json")).empty()); // its results are there all the same
	EXPECT_EQ(run({"slice", image(), "--classify", "cpu", "--strict"}).status, 0);
	EXPECT_EQ(run({"slice", image(), "--array", "nothing", "--classify", "cpu", "--strict"}).status, 2);
}

TEST_F(Slice, PlaneThatMissesTheGrid)
{
	for (const std::string output : {"empty.vtp", "empty.ply", "empty.csv"})
	{
		const Outcome outcome = run({"slice", image(), "--origin", "100", "0", "0", "--normal", "x", "--classify",
		                             "cpu", "-o", path(output), "--stats", path("stats.json")});
		EXPECT_TRUE(isDoneWithAWord(outcome, {"vprobe: warning: ", "empty"}));
		EXPECT_FALSE(contents(path(output)).empty()) << output;
		const nlohmann::json sheet = nlohmann::json::parse(contents(path("stats.json")))["sheets"][0];
		EXPECT_EQ(sheet["cut_cells"], 0);
		EXPECT_EQ(sheet["area"], 0.0);
		EXPECT_TRUE(sheet["mean"].is_null());
	}
}

TEST_F(Slice, RealData)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder";
	const std::string folder = data;
	const std::string grid = folder + "/structured/bluntfin/bluntfinxyz.bin";
	EXPECT_GT(stats({grid, "--array", "Density"})["sheets"][0]["cut_cells"], 0);
	std::string solution;
	for (const auto& entry : std::filesystem::directory_iterator(folder + "/structured/bluntfin"))
		if (entry.path() != grid)
			solution = entry.path();
	EXPECT_GT(stats({grid, "--solution", solution, "--array", "Density"})["sheets"][0]["cut_cells"], 0);
	// The same name for points and cells.
	const std::string both = folder + "/structured/SampleStructGrid/SampleStructGrid.vtk";
	EXPECT_NE(stats({both, "--array", "point:scalars"})["sheets"][0]["mean"],
	          stats({both, "--array", "cell:scalars"})["sheets"][0]["mean"]);
	EXPECT_EQ(stats({both, "--array", "scalars"})["sheets"][0]["mean"],
	          stats({both, "--array", "point:scalars"})["sheets"][0]["mean"]);
}

namespace
{

// The corner of a ball as one quadratic tetrahedron, with x as its array.
std::string ballCorner()
{
	return "# vtk DataFile Version 3.0\nball\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 double\n"
	       "0 0 0 1 0 0 0 1 0 0 0 1 .5 0 0 .707106781 .707106781 0 0 .5 0 0 0 .5 .707106781 0 .707106781 "
	       "0 .707106781 .707106781\nCELLS 1 11\n10 0 1 2 3 4 5 6 7 8 9\nCELL_TYPES 1\n24\n"
	       "POINT_DATA 10\nSCALARS x double 1\nLOOKUP_TABLE default\n0 1 0 0 .5 .707106781 0 0 .707106781 0\n";
}

} // namespace

TEST_F(Slice, ATolerantCutRefinesWhatItMeets)
{
	const std::string file = write("ball.vtk", ballCorner());
	const Arguments cut{file, "--origin", "0", "0", "0.3"};
	const nlohmann::json coarse = stats(cut + Arguments{"--refine", "0.5"});
	const nlohmann::json fine = stats(cut + Arguments{"--refine", "0.001"});
	EXPECT_EQ(coarse["refined"],
	          (nlohmann::json{{"cells_looked_at", 1}, {"cells", 1}, {"parts", 1}, {"unfinished", 0}}));
	EXPECT_GT(fine["refined"]["parts"], 50);
	EXPECT_EQ(fine["refined"]["parts"], fine["sheets"][0]["cells_scanned"]);
	EXPECT_EQ(fine["sheets"][0]["cut_cells"], 1);
	EXPECT_GT(fine["sheets"][0]["area"], 1.5 * coarse["sheets"][0]["area"].get<double>());
	EXPECT_EQ(fine["plan"][0]["strategy"], "scan");
	EXPECT_TRUE(stats({file, "--origin", "0", "0", "0.3", "--refine", "1"})["refined"].is_null());
	// An eighth of a sphere within the ball.
	const nlohmann::json sphere =
	    stats({file, "--origin", "0", "0", "0", "--surface", "sphere:0.5", "--refine", "1e-3"});
	EXPECT_GT(sphere["sheets"][0]["area"], 0.1);
	EXPECT_TRUE(isQuiet(run({"slice", file, "--refine", "0.01", "--normal", "1", "1", "1", "-o", path("cut.vtp")})));
	EXPECT_TRUE(contains(contents(path("cut.vtp")), "Name=\"x\""));
	EXPECT_TRUE(isQuiet(run({"profile", file, "--refine", "0.01", "--planes", "3"})) ||
	            isDoneWithAWord(run({"profile", file, "--refine", "0.01", "--planes", "3"}), {"empty"}));
}

TEST_F(Slice, WhatAToleranceDoesNotServeIsAUsageError)
{
	const std::string file = write("ball.vtk", ballCorner());
	for (const auto& [options, word] :
	     std::vector<std::pair<Arguments, std::string>>{{{"--threshold", "0", "1"}, "threshold"},
	                                                    {{"--surface", "iso:0.5"}, "surface"},
	                                                    {{"--crinkle"}, "crinkle"},
	                                                    {{"--contour", "0.5"}, "contour"},
	                                                    {{"--seeds", "hotspot"}, "seeds"},
	                                                    {{"--strategy", "cells"}, "cells"}})
		EXPECT_TRUE(isError(run(Arguments{"slice", file, "--refine", "0.01"} + options), 1, {word, "--refine 1"}))
		    << word;
	EXPECT_TRUE(isError(run({"slice", file, "--refine", "1.5"}), 1, {"refine", "1.5", "between 0 and 1"}));
	EXPECT_TRUE(isError(run({"slice", file, "--refine", "1e-9"}), 1, {"refine", "at least"}));
	EXPECT_TRUE(isError(run({"check", file, "--refine", "0.01"}), 1, {"refine", "level"}));
	EXPECT_TRUE(isError(run({"sample", file, "--refine", "0.01", "--points", "-"}), 1, {"refine", "level"}));
}

} // namespace cli
