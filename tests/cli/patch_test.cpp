// --surface patch=NAME: what a file names of its boundary.

#include "program.h"
#include "tries.h"

namespace cli
{

namespace
{

using nlohmann::json;

class PatchOfAFile : public Program
{
protected:
	// A unit cube as an OpenFOAM case: one face is the inlet, the others are walls. T is 300.
	std::string foamCase() const
	{
		const auto file = [&](const std::string& name, const std::string& kind, const std::string& body)
		{
			std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
			write(name, "FoamFile\n{\n version 2.0;\n format ascii;\n class " + kind + ";\n object " +
			                std::filesystem::path(name).filename().string() + ";\n}\n" + body);
		};
		file("system/controlDict", "dictionary",
		     "startFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 0;\ndeltaT 1;\nwriteControl timeStep;\n"
		     "writeInterval 1;\n");
		file("constant/polyMesh/points", "vectorField",
		     "8\n(\n(0 0 0)\n(1 0 0)\n(1 1 0)\n(0 1 0)\n(0 0 1)\n(1 0 1)\n(1 1 1)\n(0 1 1)\n)\n");
		file("constant/polyMesh/faces", "faceList",
		     "6\n(\n4(0 4 7 3)\n4(1 2 6 5)\n4(0 1 5 4)\n4(3 7 6 2)\n4(0 3 2 1)\n4(4 5 6 7)\n)\n");
		file("constant/polyMesh/owner", "labelList", "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
		file("constant/polyMesh/neighbour", "labelList", "0\n(\n)\n");
		file("constant/polyMesh/boundary", "polyBoundaryMesh",
		     "2\n(\ninlet\n{\n type patch;\n nFaces 1;\n startFace 0;\n}\nwalls\n{\n type wall;\n "
		     "inGroups 2(wall hot);\n nFaces 5;\n startFace 1;\n}\n)\n");
		file("0/T", "volScalarField",
		     "dimensions [0 0 0 1 0 0 0];\ninternalField uniform 300;\nboundaryField\n{\n inlet { type fixedValue; "
		     "value "
		     "uniform 300; }\n walls { type zeroGradient; }\n}\n");
		return write("cube.foam", "");
	}
};

} // namespace

TEST_F(PatchOfAFile, IsShownWithItsValues)
{
	const std::string file = foamCase();
	const json inlet = stats({file, "--surface", "patch=inlet", "--array", "cell:T"}).at("sheets").at(0);
	EXPECT_EQ(inlet["surface"], "patch=inlet");
	EXPECT_TRUE(inlet["normal"].is_null());
	EXPECT_EQ(inlet["polygons"], 1);
	EXPECT_NEAR(inlet["area"], 1.0, 1e-12);
	EXPECT_NEAR(inlet["mean"], 300.0, 1e-9);
	const json walls = stats({file, "--surface", "patch=walls"}).at("sheets").at(0);
	EXPECT_EQ(walls["polygons"], 5);
	EXPECT_EQ(walls["vertices"], 8);
	EXPECT_EQ(walls["cut_cells"], 1);
	EXPECT_NEAR(walls["area"], 5.0, 1e-12);
	const std::string told = run({"info", file}).out;
	EXPECT_TRUE(contains(told, "patch   inlet: 1 faces\n")) << told;
	EXPECT_TRUE(contains(told, "patch   walls: ")) << told;
	EXPECT_NEAR(stats({file, "--surface", "patch=hot"}).at("sheets").at(0)["area"], 5.0, 1e-12); // a group of patches
	EXPECT_TRUE(isQuiet(run({"slice", file, "--surface", "patch=walls", "-o", path("walls.vtp")})));
	// Runs that do not ask for patches read the file as before.
	EXPECT_EQ(stats({file}).at("sheets").at(0).at("cut_cells"), 1);
}

TEST_F(PatchOfAFile, ThatThereIsNotIsOneLine)
{
	EXPECT_TRUE(isError(run({"slice", foamCase(), "--surface", "patch=outlet"}), 2,
	                    {"--surface patch=outlet", "inlet", "walls"}));
	EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--surface", "patch=outlet"}), 2, {"patch=outlet", "OpenFOAM"}));
	EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--surface", "patch=a", "--normal", "x"}), 1, {"--normal"}));
	EXPECT_TRUE(isError(
	    run({"sweep", "demo:shell:4", "--surface", "patch=a", "--frames", "2", "-o", path("a.pvd")}, noDevice()), 1,
	    {"patch=a", "--path times"}));
}

TEST_F(PatchOfAFile, OfRealCases)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder";
	const std::string folder = data;
	const auto shown = [&](const char* file, const char* patch) {
		return stats({folder + file, "--surface", std::string("patch=") + patch}).at("sheets").at(0);
	};
	const json lid = shown("/formats/cavity_foam/case.foam", "movingWall");
	EXPECT_EQ(lid["polygons"], 20);
	EXPECT_NEAR(lid["area"], 0.001, 1e-9);
	if (vp::test::tryEvery() > 1)
		return; // the others are larger
	EXPECT_EQ(shown("/polyhedral/flange/flange.foam", "flange_patch1")["polygons"], 6463);
	EXPECT_EQ(shown("/time/mug/mug.e", "bottom")["polygons"], 478);
	EXPECT_EQ(shown("/unstructured/disk_out_ref/disk_out_ref.ex2", "3")["polygons"], 828);
}

} // namespace cli
