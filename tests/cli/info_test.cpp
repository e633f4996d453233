#include "program.h"
#include "sample_files.h"

#include <cstdlib>

namespace cli
{

namespace
{

class Info : public Program
{
};

const nlohmann::json* find(const nlohmann::json& arrays, const std::string& name, const std::string& association)
{
	for (const nlohmann::json& array : arrays)
		if (array["name"] == name && array["association"] == association)
			return &array;
	return nullptr;
}

} // namespace

// Bounds of a narrow grid far from the origin differ.
TEST_F(Info, HasAsManyDigitsAsTheWidthNeeds)
{
	std::string far = legacyImage();
	const auto at = far.find("ORIGIN 0 0 0");
	ASSERT_NE(at, std::string::npos);
	far.replace(at, 12, "ORIGIN 500000.25 6700000 10000000");
	const Outcome outcome = run({"info", write("far.vtk", far)});
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_TRUE(contains(outcome.out, "x 500000.25 to 500003.25, y 6700000 to 6700003, z 10000000 to 10000003\n"))
	    << outcome.out;
}

TEST_F(Info, TellsTheLatticeOfAnImage)
{
	const std::string image = write("i.vtk", legacyImage());
	EXPECT_TRUE(contains(run({"info", image}).out, "        4 x 4 x 4 points, 1 x 1 x 1 apart\n"));
	const nlohmann::json block = run({"info", image, "--json"}).json()["blocks"][0];
	EXPECT_EQ(block["lattice"], (nlohmann::json{4, 4, 4}));
	EXPECT_EQ(block["spacing"], (nlohmann::json{1.0, 1.0, 1.0}));
	EXPECT_TRUE(contains(run({"info", "demo:shell:8"}).out, "        9 x 9 x 9 points\n"));
	EXPECT_FALSE(contains(run({"info", "demo:tets:4"}).out, " x 4 points"));
}

TEST_F(Info, JsonKeepsItsKeys)
{
	const Outcome outcome = run({"info", "demo:shell:8", "--json"});
	ASSERT_TRUE(isQuiet(outcome));
	const nlohmann::json info = outcome.json();
	ASSERT_TRUE(info.is_object()) << outcome.out;
	EXPECT_EQ(info["grid"]["kind"], "curvilinear");
	EXPECT_EQ(info["grid"]["cells"], 512);
	EXPECT_EQ(info["grid"]["points"], 729);
	EXPECT_EQ(info["grid"]["blocks"], 1);
	ASSERT_EQ(info["bounds"].size(), 6u);
	EXPECT_NEAR(info["bounds"][0], -3.0, 1e-6);
	EXPECT_NEAR(info["bounds"][1], 3.0, 1e-6);
	EXPECT_TRUE(info["times"].is_array());
	const nlohmann::json* s = find(info["arrays"], "s", "point");
	const nlohmann::json* v = find(info["arrays"], "v", "point");
	ASSERT_TRUE(s && v) << info["arrays"];
	EXPECT_EQ((*s)["components"], 1);
	EXPECT_EQ((*v)["components"], 3);
	EXPECT_TRUE((*s)["type"].is_string());
	EXPECT_EQ((*s)["range"].size(), 2u);
}

TEST_F(Info, KindOfEveryDemo)
{
	const std::pair<const char*, const char*> kinds[] = {
	    {"shell", "curvilinear"},  {"hexes", "unstructured"}, {"tets", "unstructured"}, {"blob", "image"},
	    {"graded", "rectilinear"}, {"mixed", "unstructured"}, {"layer", "unstructured"}};
	for (const auto& [demo, kind] : kinds)
		EXPECT_EQ(run({"info", std::string("demo:") + demo + ":4", "--json"}).json()["grid"]["kind"], kind) << demo;
}

TEST_F(Info, DemoWithoutANameListsThem)
{
	const Outcome outcome = run({"info", "demo:"});
	ASSERT_TRUE(isQuiet(outcome));
	for (const char* name : {"shell", "hexes", "tets", "blob", "graded", "mixed", "layer"})
		EXPECT_TRUE(contains(outcome.out, name)) << name;
}

TEST_F(Info, Files)
{
	const Outcome image = run({"info", write("image.vtk", legacyImage()), "--json"});
	ASSERT_TRUE(isQuiet(image));
	EXPECT_EQ(image.json()["grid"]["kind"], "image");
	EXPECT_EQ(image.json()["grid"]["cells"], 27);
	const nlohmann::json arrays = image.json()["arrays"];
	for (const char* name : {"height", "both", "wind"})
		EXPECT_TRUE(find(arrays, name, "point")) << name;
	for (const char* name : {"both", "mass"})
		EXPECT_TRUE(find(arrays, name, "cell")) << name;
	EXPECT_EQ(run({"info", write("image.vti", xmlImage()), "--json"}).json()["grid"]["cells"], 27);
	EXPECT_EQ(run({"info", write("cells.vtu", xmlHexahedra()), "--json"}).json()["grid"]["cells"], 2);
}

TEST_F(Info, TableNamesTheArrays)
{
	const Outcome outcome = run({"info", "demo:shell:8"});
	ASSERT_TRUE(isQuiet(outcome));
	for (const char* word : {"curvilinear", "512", "729", "s", "v"})
		EXPECT_TRUE(contains(outcome.out, word)) << word;
}

TEST_F(Info, SeveralInputsAreOneBlockSet)
{
	const nlohmann::json info = run({"info", "demo:shell:4", "demo:blob:4", "--json"}).json();
	EXPECT_EQ(info["grid"]["blocks"], 2);
	EXPECT_EQ(info["grid"]["cells"], 128);
	ASSERT_EQ(info["blocks"].size(), 2u);
	EXPECT_EQ(info["blocks"][1]["cells"], 64);
	EXPECT_EQ(info["seam_faces"], 0);
	EXPECT_EQ(info["boundary_faces"], 2 * 6 * 16);
}

TEST_F(Info, BlocksThatMeet)
{
	// The same image twice: every boundary face lies on another.
	const std::string file = write("image.vtk", legacyImage());
	const nlohmann::json info = run({"info", file, file, "--json"}).json();
	EXPECT_EQ(info["interfaces"], nlohmann::json::parse(R"([{"blocks": [0, 1], "faces": 54}])"));
	EXPECT_EQ(info["seam_faces"], 108);
	EXPECT_EQ(info["boundary_faces"], 0);
	EXPECT_TRUE(contains(run({"info", file, file}).out, "108 boundary faces lie on another"));
}

// Three cells wide, the second image begins at x.
TEST_F(Info, BlocksThatAbutOverlapOrAreApart)
{
	const std::string first = write("first.vtk", legacyImage());
	const auto second = [&](const std::string& x)
	{
		std::string text = legacyImage();
		const std::size_t at = text.find("ORIGIN 0 ");
		EXPECT_NE(at, std::string::npos);
		return write("second.vtk", text.replace(at, 9, "ORIGIN " + x + " "));
	};
	struct Case
	{
		const char* x;
		int faces; // faces of one block that lie on faces of the other
		std::size_t overlaps;
	};
	for (const Case& c : {Case{"3", 9, 0}, Case{"2.5", 0, 1}, Case{"2", 12, 1}, Case{"4", 0, 0}})
	{
		SCOPED_TRACE(c.x);
		const std::string other = second(c.x);
		const nlohmann::json info = run({"info", first, other, "--json"}).json();
		EXPECT_EQ(info["blocks"].size(), 2u);
		ASSERT_EQ(info["interfaces"].size(), c.faces ? 1u : 0u);
		ASSERT_EQ(info["overlaps"].size(), c.overlaps);
		const std::string words = run({"info", first, other}).out;
		EXPECT_TRUE(contains(words, "block   1:"));
		EXPECT_EQ(contains(words, "block 0 meets block 1 in " + std::to_string(c.faces) + " faces"), c.faces > 0);
		EXPECT_EQ(contains(words, "blocks 0 and 1 have room in common"), c.overlaps == 1);
		if (c.overlaps)
		{
			EXPECT_EQ(info["overlaps"][0]["blocks"], nlohmann::json({0, 1}));
			EXPECT_EQ(info["overlaps"][0]["cells"], 18); // a layer of either block
		}
	}
}

TEST_F(Info, OneBlockHasNothingToMeet)
{
	const nlohmann::json info = run({"info", "demo:mixed:4", "--json"}).json();
	EXPECT_EQ(info["interfaces"], nlohmann::json::array());
	EXPECT_EQ(info["overlaps"], nlohmann::json::array());
	const std::string words = run({"info", "demo:mixed:4"}).out;
	EXPECT_FALSE(contains(words, "block   0"));
	EXPECT_FALSE(contains(words, "overlap"));
}

TEST_F(Info, RealSetsOfBlocks)
{
	const char* data = std::getenv("VPROBE_DATA");
	if (!data)
		GTEST_SKIP() << "VPROBE_DATA names no folder";
	const std::string folder = std::string(data) + "/multiblock/";
	const nlohmann::json abut = run({"info", folder + "multi_bin/multi-bin-C.xyz", "--json"}).json();
	EXPECT_EQ(abut["blocks"].size(), 2u);
	EXPECT_EQ(abut["interfaces"].size(), 1u);
	EXPECT_EQ(abut["overlaps"], nlohmann::json::array());
	const std::string comb = folder + "multicomb/multicomb_";
	const nlohmann::json three = run({"info", comb + "0.vts", comb + "1.vts", comb + "2.vts", "--json"}).json();
	EXPECT_EQ(three["blocks"].size(), 3u);
	EXPECT_EQ(three["interfaces"].size(), 2u);
	const nlohmann::json twice = run({"info", comb + "0.vts", comb + "1.vts", comb + "1.vts", "--json"}).json();
	ASSERT_EQ(twice["overlaps"].size(), 1u);
	EXPECT_EQ(twice["overlaps"][0]["blocks"], nlohmann::json({1, 2}));
	EXPECT_EQ(twice["overlaps"][0]["cells"], twice["overlaps"][0]["samples"]);
}

} // namespace cli
