#include "program.h"
#include "sample_files.h"

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
	const std::pair<const char*, const char*> kinds[] = {{"shell", "curvilinear"},  {"hexes", "unstructured"},
	                                                     {"tets", "unstructured"},  {"blob", "image"},
	                                                     {"graded", "rectilinear"}, {"mixed", "unstructured"}};
	for (const auto& [demo, kind] : kinds)
		EXPECT_EQ(run({"info", std::string("demo:") + demo + ":4", "--json"}).json()["grid"]["kind"], kind) << demo;
}

TEST_F(Info, DemoWithoutANameListsThem)
{
	const Outcome outcome = run({"info", "demo:"});
	ASSERT_TRUE(isQuiet(outcome));
	for (const char* name : {"shell", "hexes", "tets", "blob", "graded", "mixed"})
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

} // namespace cli
