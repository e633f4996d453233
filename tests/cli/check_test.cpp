#include "program.h"
#include "sample_files.h"
#include "tries.h"

#include <cstdlib>

namespace cli
{

namespace
{

class Check : public Program
{
protected:
	// Two unit cubes: the second one mirrored, and beside the first without sharing points.
	std::string faulty() const
	{
		return write("faulty.vtk",
		             "# vtk DataFile Version 3.0\nfaulty\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 17 float\n"
		             "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n"
		             "1 0 0 2 0 0 2 1 0 1 1 0 1 0 1 2 0 1 2 1 1 1 1 1\n"
		             "9 9 9\n"
		             "CELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 12 13 14 15 8 9 10 11\nCELL_TYPES 2\n12\n12\n");
	}
};

} // namespace

TEST_F(Check, CleanGridsGiveZero)
{
	for (const char* demo : {"demo:shell:8", "demo:hexes:8", "demo:tets:4", "demo:mixed:6", "demo:blob:8",
	                         "demo:graded:8", "demo:layer:8"})
	{
		const Outcome outcome = run({"check", demo, "--json"});
		ASSERT_TRUE(isQuiet(outcome)) << demo << outcome.out;
		const nlohmann::json json = outcome.json();
		for (const char* key : {"collapsed_cells", "inverted_cells", "twisted_cells", "impossible_cases",
		                        "coincident_points", "seam_faces", "nonmanifold_faces", "orphan_points", "overlaps"})
			EXPECT_EQ(json[key], 0) << demo << " " << key;
		EXPECT_EQ(json["clean"], true);
	}
	EXPECT_TRUE(contains(run({"check", "demo:shell:8"}).out, "no fault"));
}

TEST_F(Check, FaultsGiveFive)
{
	const Outcome outcome = run({"check", faulty(), "--json"});
	EXPECT_EQ(outcome.status, 5);
	EXPECT_EQ(outcome.err, "");
	const nlohmann::json json = outcome.json();
	EXPECT_EQ(json["inverted_cells"], 1);
	EXPECT_EQ(json["coincident_points"], 4);
	EXPECT_EQ(json["seam_faces"], 2);
	EXPECT_EQ(json["orphan_points"], 1);
	EXPECT_EQ(json["overlaps"], 0);
	EXPECT_EQ(json["clean"], false);
	EXPECT_EQ(json["first_cells"]["inverted_cells"][0]["cell"], 1);

	const Outcome table = run({"check", faulty()});
	EXPECT_EQ(table.status, 5);
	for (const char* word : {"inverted_cells", "coincident_points", "seam_faces", "orphan_points"})
		EXPECT_TRUE(contains(table.out, word)) << word;
	EXPECT_FALSE(contains(table.out, "overlaps "));
}

// Cells of a discontinuous Galerkin method, and tetrahedra as LS-DYNA lists them.
TEST_F(Check, CellsWithOwnPointsAndDegenerateCellsAreNoFault)
{
	const Outcome own =
	    run({"check",
	         write("own.vtk", "# vtk DataFile Version 3.0\nown\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 16 float\n"
	                          "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n"
	                          "1 0 0 2 0 0 2 1 0 1 1 0 1 0 1 2 0 1 2 1 1 1 1 1\n"
	                          "CELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 8 9 10 11 12 13 14 15\nCELL_TYPES 2\n12\n12\n"),
	         "--json"});
	EXPECT_EQ(own.status, 0) << own.out;
	EXPECT_EQ(own.json()["coincident_points"], 4);
	EXPECT_EQ(own.json()["seam_faces"], 2);
	const std::string tetrahedra =
	    write("dyna.vtk", "# vtk DataFile Version 3.0\nd\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n"
	                      "0 0 0 1 0 0 0 1 0 0 0 1 0 0 -1\n"
	                      "CELLS 2 18\n8 0 1 2 3 3 3 3 3\n8 0 2 1 4 4 4 4 4\nCELL_TYPES 2\n12\n12\n");
	const Outcome dyna = run({"check", tetrahedra, "--json"});
	EXPECT_EQ(dyna.status, 0) << dyna.out;
	EXPECT_EQ(dyna.json()["degenerate_cells"], 2);
	EXPECT_EQ(dyna.json()["collapsed_cells"], 0);
	EXPECT_TRUE(contains(run({"check", tetrahedra}).out, "degenerate_cells"));
}

// A point that no cell uses changes no figure.
TEST_F(Check, PointsOfNoCellAreNoFault)
{
	const auto check = [&](const std::string& points)
	{
		return run(
		    {"check",
		     write("orphan.vtk", "# vtk DataFile Version 3.0\no\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n" +
		                             points + "CELLS 2 10\n4 0 1 2 3\n4 0 2 1 4\nCELL_TYPES 2\n10\n10\n"),
		     "--json"});
	};
	const Outcome orphan = check("0 0 0 1 0 0 0 1 0 0 0 1 0 0 -1 9 9 9\n");
	EXPECT_EQ(orphan.status, 0) << orphan.out;
	EXPECT_EQ(orphan.json()["orphan_points"], 1);
	EXPECT_EQ(orphan.json()["clean"], true);
	EXPECT_EQ(orphan.json()["grid"]["cells_without_place"], 0);
	EXPECT_TRUE(contains(run({"check", path("orphan.vtk")}).out, "note"));

	const Outcome unplaced = check("0 0 0 1 0 0 0 1 0 0 0 1 0 0 1e60 9 9 9\n");
	EXPECT_EQ(unplaced.status, 0) << unplaced.out;
	EXPECT_EQ(unplaced.json()["grid"]["cells_without_place"], 1);
	EXPECT_TRUE(contains(unplaced.err, "1 cell is left out")) << unplaced.err;
	EXPECT_EQ(run({"info", path("orphan.vtk"), "--json"}).json()["grid"]["cells_without_place"], 1);
	EXPECT_TRUE(contains(run({"info", path("orphan.vtk")}).out, "1 cells with a point without a place"));
	EXPECT_EQ(run({"slice", path("orphan.vtk"), "--stats", "-"}).json()["grid"]["cells_without_place"], 1);
}

TEST_F(Check, BlocksThatMeetAreNoFaultButThoseThatOverlapAre)
{
	const std::string image = write("image.vtk", legacyImage());
	const Outcome twice = run({"check", image, image, "--json"});
	EXPECT_EQ(twice.status, 5);
	EXPECT_EQ(twice.json()["overlaps"], 27);
	EXPECT_EQ(twice.json()["seam_faces"], 108);
}

TEST_F(Check, BadCellsAreWritten)
{
	const Outcome outcome = run({"check", faulty(), "-o", path("bad.vtp")});
	EXPECT_EQ(outcome.status, 5);
	const std::string vtp = contents(path("bad.vtp"));
	for (const char* word : {"PolyData", "vprobe:finding", "vprobe:cell", "vprobe:block"})
		EXPECT_TRUE(contains(vtp, word)) << word;
	const Outcome piped = run({"check", faulty(), "-o", "-"});
	EXPECT_EQ(piped.status, 5);
	EXPECT_EQ(piped.out, vtp);
	EXPECT_EQ(run({"check", "demo:shell:4", "-o", path("none.vtp")}).status, 0);
}

TEST_F(Check, WrongUsage)
{
	EXPECT_TRUE(isError(run({"check", "demo:shell:4", "-o", path("bad.ply")}), 1, {"-o", ".vtp"}));
	EXPECT_TRUE(isError(run({"check", "demo:shell:4", "--json", "-o", "-"}), 1, {"--json", "standard output"}));
	EXPECT_TRUE(isError(run({"check"}), 1, {"INPUT"}));
	EXPECT_TRUE(isError(run({"check", path("missing.vtk")}), 2, {"missing.vtk"}));
	EXPECT_EQ(run({"check", faulty(), "-o", path("no/such/folder/bad.vtp")}).status, 5);
	EXPECT_TRUE(std::filesystem::is_regular_file(path("no/such/folder/bad.vtp")));
}

TEST_F(Check, RealSets)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA does not name the data sets";
	const auto check = [&](const std::string& file)
	{
		const Outcome outcome = run({"check", std::string(data) + "/" + file, "--json"});
		EXPECT_EQ(outcome.status, outcome.json()["clean"] == true ? 0 : 5) << file;
		return outcome.json();
	};
	EXPECT_EQ(check("topology/manifoldCheck0/manifoldCheck0.vtu")["nonmanifold_points"], 3);
	EXPECT_GT(check("topology/manifoldCheck1/manifoldCheck1.vtu")["nonmanifold_edges"], 0);
	const nlohmann::json folded = check("topology/manifoldCheck2/manifoldCheck2.vtu");
	EXPECT_EQ(folded["nonmanifold_faces"], 1);
	EXPECT_GT(folded["overlaps"], 0);
	if (vp::test::tryEvery() > 1)
		return; // the others are larger
	EXPECT_EQ(check("structured/bluntfin/bluntfinxyz.bin")["collapsed_cells"], 39);
	const nlohmann::json sector = check("unstructured/AngularSector/AngularSector.vtk");
	EXPECT_EQ(sector["coincident_points"], 1014);
	EXPECT_GT(sector["seam_faces"], 0);
	EXPECT_EQ(check("unstructured/post_tets/post.vtk")["coincident_points"], 88);
	EXPECT_EQ(check("structured/SampleStructGrid/SampleStructGrid.vtk")["inverted_cells"], 0); // all left-handed
	EXPECT_EQ(check("multiblock/multi_bin/multi-bin-C.xyz")["clean"], true);
	EXPECT_EQ(check("structured/office/office.binary.vtk")["clean"], true);
}

} // namespace cli
