// Tests the figures of vectors that are launched from sheets. drawn_vectors_test.cpp tests their pictures.

#include "program.h"
#include "sample_files.h"

#include <cmath>

namespace cli
{

namespace
{

using nlohmann::json;

class Vectors : public Program
{
protected:
	json sheet(const Arguments& options) const { return stats(Arguments{"demo:shell:16"} + options)["sheets"][0]; }
};

struct BadVectorOption
{
	Arguments options;
	int status;
	std::vector<std::string> words;
};
class BadVectors : public Program, public testing::WithParamInterface<BadVectorOption>
{
};

std::size_t sum(const json& ends)
{
	std::size_t all = 0;
	for (const json& end : ends)
		all += end.get<std::size_t>();
	return all;
}

} // namespace

TEST_F(Vectors, TuftsAreOneStepLong)
{
	const json figures = sheet({"--vectors", "tufts"})["vectors"];
	EXPECT_EQ(figures["array"], "v");
	const auto traces = figures["traces"].get<std::size_t>();
	EXPECT_GT(traces, 100u);
	EXPECT_LE(traces, 400u);
	EXPECT_EQ(figures["points"], 2 * traces);
	EXPECT_EQ(sum(figures["ends"]), traces);
	EXPECT_GT(figures["ends"]["steps"].get<std::size_t>(), traces / 2);
	// The grid is 6 across, and v (-y, x, 0.3).
	EXPECT_NEAR(figures["dt"].get<double>(), 6.0 / 20 / std::sqrt(9.09), 1e-4);
	EXPECT_FALSE(sheet({}).contains("vectors"));
	EXPECT_GT(stats({"demo:shell:16", "--vectors", "tufts"})["ms"]["trace"].get<double>(), 0.0);
}

TEST_F(Vectors, StepsGoOnFromTheTuftWithoutAJump)
{
	const auto points = [&](const std::string& steps)
	{
		const json figures = sheet({"--vectors", "lines", "--vector-steps", steps, "--vector-dt", "0.001"})["vectors"];
		return figures["points"].get<double>() / figures["traces"].get<double>();
	};
	EXPECT_EQ(points("0"), 1.0);
	EXPECT_NEAR(points("0.5"), 2.0, 0.05);
	EXPECT_NEAR(points("1"), 2.0, 0.05);
	EXPECT_NEAR(points("2.5"), 4.0, 0.1);
	EXPECT_EQ(sheet({"--vectors", "tubes"})["vectors"],
	          sheet({"--vectors", "lines", "--vector-steps", "200"})["vectors"]);
}

TEST_F(Vectors, LatticeAndDirectionSayHowMany)
{
	const json few = sheet({"--vectors", "tufts", "--vector-lattice", "5"})["vectors"];
	const json both = sheet({"--vectors", "tufts", "--vector-lattice", "5", "--vector-direction", "both"})["vectors"];
	EXPECT_LE(few["traces"].get<std::size_t>(), 25u);
	EXPECT_EQ(both["traces"], few["traces"]);
	EXPECT_EQ(sum(both["ends"]), 2 * both["traces"].get<std::size_t>());
	EXPECT_GT(both["points"], few["points"]);
	// A window bounds what is launched.
	const json window = sheet({"--origin", "0", "2", "0", "--window", "0.4", "0.2", "--vectors", "tufts",
	                           "--vector-lattice", "8"})["vectors"];
	EXPECT_EQ(window["traces"], 32);
	EXPECT_NEAR(window["dt"].get<double>(), 0.4 / 8 / std::sqrt(9.09), 1e-4);
}

TEST_F(Vectors, PartsAreOfTheSheet)
{
	const Arguments rake{"--vectors", "lines", "--vector-dt", "0.05", "--vector-steps", "300", "--vector-part"};
	// v's part through a plane of constant z is 0.3 everywhere: all leave the grid.
	const json through = sheet(rake + Arguments{"normal"})["vectors"];
	EXPECT_EQ(through["ends"]["left_grid"], through["traces"]);
	const json within = sheet(rake + Arguments{"tangential"})["vectors"];
	EXPECT_NE(within["points"], sheet(rake + Arguments{"whole"})["vectors"]["points"]);
}

TEST_F(Vectors, FluxIsOfTheVectorsChosenOrShown)
{
	const json chosen = sheet({"--vector-array", "v"});
	EXPECT_NEAR(chosen["flux"].get<double>(), 0.3 * chosen["area"].get<double>(), 1e-5);
	EXPECT_EQ(sheet({"--array", "v"})["flux"], chosen["flux"]);
	EXPECT_EQ(sheet({"--vectors", "tufts"})["flux"], chosen["flux"]);
	EXPECT_TRUE(sheet({"--array", "s"})["flux"].is_null());
	EXPECT_NEAR(sheet({"--array", "v", "--normal", "0", "0", "-1"})["flux"].get<double>(),
	            -chosen["flux"].get<double>(), 1e-5);
}

TEST_F(Vectors, AStateBringsThemBack)
{
	const Arguments all{"--vectors",       "ribbons",    "--vector-array",     "point:v", "--vector-lattice", "7",
	                    "--vector-jitter", "0.5",        "--vector-steps",     "12.25",   "--vector-dt",      "0.03125",
	                    "--vector-part",   "tangential", "--vector-direction", "backward"};
	const json figures = sheet(all + Arguments{"--save", path("a.json")});
	EXPECT_EQ(stats({"--state", path("a.json"), "--save", path("b.json")})["sheets"][0], figures);
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
	EXPECT_FALSE(stats({"--state", path("a.json"), "--vectors", "none"})["sheets"][0].contains("vectors"));
}

TEST_P(BadVectors, IsOneLine)
{
	const BadVectorOption& bad = GetParam();
	EXPECT_TRUE(isError(run(Arguments{"slice", "--classify", "cpu"} + bad.options), bad.status, bad.words));
}

INSTANTIATE_TEST_SUITE_P(
    Options, BadVectors,
    testing::Values(
        BadVectorOption{{"demo:shell:4", "--vectors", "hairs"}, 1, {"--vectors", "tufts"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-array", "s"},
                        2,
                        {"--vector-array s", "1 component", "point:v"}},
        BadVectorOption{
            {"demo:shell:4", "--vectors", "tufts", "--vector-array", "w"}, 2, {"--vector-array w", "point:v"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-dt", "0"}, 1, {"--vector-dt 0", "above 0"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-dt", "nan"}, 1, {"--vector-dt nan"}},
        BadVectorOption{
            {"demo:shell:4", "--vectors", "tufts", "--vector-steps", "-1"}, 1, {"--vector-steps -1", "backward"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tubes", "--vector-steps", "1e6", "--vector-lattice", "1000"},
                        1,
                        {"--vector-steps 1000000", "fewer"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-lattice", "0"}, 1, {"--vector-lattice"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-jitter", "1.5"}, 1, {"--vector-jitter"}},
        BadVectorOption{{"demo:shell:4", "--vectors", "tufts", "--vector-jitter", "nan"}, 1, {"--vector-jitter"}},
        BadVectorOption{
            {"demo:shell:4", "--vectors", "tufts", "--vector-direction", "up"}, 1, {"--vector-direction", "backward"}},
        BadVectorOption{
            {"demo:shell:4", "--vectors", "tufts", "--vector-part", "half"}, 1, {"--vector-part", "tangential"}},
        BadVectorOption{
            {"demo:shell:4", "--vectors", "tufts", "--surface", "i=2"}, 1, {"--vectors", "--surface i=2"}}));

TEST_F(Vectors, AreWrittenAsLinesThatSayWhyTheyEnd)
{
	const Arguments rake{"slice", "demo:shell:12",    "--vectors", "lines",      "--vector-steps",
	                     "20",    "--vector-lattice", "6",         "--classify", "cpu"};
	ASSERT_TRUE(isQuiet(run(rake + Arguments{"--vectors-out", path("a.vtp"), "--stats", path("s.json")})));
	const std::string text = contents(path("a.vtp"));
	for (const char* part :
	     {"<PolyData>", "NumberOfLines=", "vprobe:time", "vprobe:vector", "vprobe:end", "Name=\"s\"", "</VTKFile>"})
		EXPECT_TRUE(contains(text, part)) << part;
	const json traces = json::parse(contents(path("s.json")))["sheets"][0]["vectors"];
	EXPECT_TRUE(contains(text, "NumberOfLines=\"" + std::to_string(traces["traces"].get<int>()) + "\""));
	EXPECT_TRUE(contains(text, "NumberOfPoints=\"" + std::to_string(traces["points"].get<int>()) + "\""));
	const Outcome piped = run(rake + Arguments{"--vectors-out", "-"});
	EXPECT_EQ(piped.status, 0);
	EXPECT_EQ(piped.out, text);
	EXPECT_TRUE(
	    isError(run(rake + Arguments{"--vectors-out", "-", "--stats", "-"}), 1, {"--vectors-out -", "--stats -"}));
	EXPECT_TRUE(isError(run(rake + Arguments{"--vectors-out", path("a.csv")}), 1, {"a.csv", ".vtp"}));
	write("none", "a file where the folder would be");
	EXPECT_TRUE(isError(run(rake + Arguments{"--vectors-out", path("none/a.vtp")}), 4, {"none/a.vtp"}));
	EXPECT_TRUE(isError(run({"slice", "demo:shell:12", "--vectors-out", path("b.vtp")}), 1,
	                    {"--vectors-out", "--vectors tufts"}));
	EXPECT_TRUE(isError(run(rake + Arguments{"-o", path("a.png")}), 1, {"--vectors", "render"}));
}

TEST_F(Vectors, PathLinesFollowTheTimes)
{
	// The wind is (1, 2, 2) at time 0, and turns about by time 1.
	std::string later = legacyImage();
	for (std::size_t at = later.find("1 2 2"); at != std::string::npos; at = later.find("1 2 2", at))
		later.replace(at, 5, "-1 -2 -2");
	write("a.vtk", legacyImage());
	write("b.vtk", later);
	const std::string series = write("a.vtk.series", R"({"file-series-version": "1.0", "files": [
		{"name": "a.vtk", "time": 0}, {"name": "b.vtk", "time": 1}]})");
	const Arguments rake{series, "--window",       "1.5", "1.5",         "--vectors", "lines", "--vector-lattice",
	                     "3",    "--vector-steps", "10",  "--vector-dt", "0.1"};
	const Arguments first{"--time", "first"};
	const json ends = stats(rake + first)["sheets"][0]["vectors"]["ends"];
	const json path_ends = stats(rake + first + Arguments{"--path-lines"})["sheets"][0]["vectors"]["ends"];
	// Straight on a particle goes 2 along y, and the grid is 3 wide; there and back again it stays within 0.5.
	EXPECT_GT(ends["left_grid"].get<int>(), 0);
	EXPECT_EQ(path_ends["left_grid"], 0);
	const Arguments slice = Arguments{"slice"} + rake + Arguments{"--path-lines"};
	EXPECT_TRUE(isError(run(slice + Arguments{"--time", "last"}), 1, {"--path-lines", "--time first"}));
	EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--vectors", "lines", "--path-lines"}), 2,
	                    {"demo:shell:4", "--path-lines"}));
}

TEST_F(Vectors, OfAnInputWithoutThem)
{
	const std::string file = write("a.vti", xmlImage());
	EXPECT_TRUE(isError(run({"slice", file, "--vectors", "tufts"}), 2, {"--vectors", "three components"}));
}

} // namespace cli
