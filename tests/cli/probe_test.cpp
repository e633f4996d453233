// Probes of several sheets on the command line, by the figures of their slices.

#include "program.h"

#include <cmath>
#include <numbers>

namespace cli
{

namespace
{

using nlohmann::json;

class Probe : public Program
{
protected:
	json sheets(const Arguments& options) const
	{
		return stats(Arguments{"demo:blob:16"} + options).value("sheets", json());
	}
	static double total(const json& sheets, const char* key)
	{
		double sum = 0.0;
		for (const json& sheet : sheets)
			sum += sheet.at(key).get<double>();
		return sum;
	}
};

class BadProbeOption : public Program, public testing::WithParamInterface<std::pair<Arguments, std::string>>
{
};

// blob is an image over -3..3: each plane through its middle cuts an area of 36.
constexpr double kWhole = 36.0;
constexpr double kNear = 1e-9;

} // namespace

TEST_F(Probe, Trihedral)
{
	const json cut = sheets({"--probe", "trihedral"});
	ASSERT_EQ(cut.size(), 3u);
	for (int axis = 0; axis < 3; ++axis)
	{
		EXPECT_NEAR(cut[axis].at("area").get<double>(), kWhole, kNear) << axis;
		for (int c = 0; c < 3; ++c)
			EXPECT_NEAR(std::abs(cut[axis].at("normal")[c].get<double>()), c == axis ? 1.0 : 0.0, kNear) << axis;
	}
}

TEST_F(Probe, PaddlewheelVanesTouchAlongTheUpAxis)
{
	const json half = sheets({"--probe", "paddlewheel", "--vanes", "2"});
	ASSERT_EQ(half.size(), 2u);
	for (const json& vane : half)
		EXPECT_NEAR(vane.at("area").get<double>(), kWhole / 2.0, kNear);
	EXPECT_EQ(sheets({"--probe", "paddlewheel"}).size(), 3u);

	const json windows = sheets({"--probe", "paddlewheel", "--vanes", "5", "--window", "1", "2"});
	ASSERT_EQ(windows.size(), 5u);
	for (const json& vane : windows)
		EXPECT_NEAR(vane.at("area").get<double>(), 2.0, kNear);
	// Consecutive vanes are 72 degrees apart about y.
	const json& a = windows[0].at("normal");
	const json& b = windows[1].at("normal");
	const double dot = a[0].get<double>() * b[0].get<double>() + a[2].get<double>() * b[2].get<double>();
	EXPECT_NEAR(std::abs(dot), std::abs(std::cos(2.0 * std::numbers::pi / 5.0)), kNear);
}

TEST_F(Probe, StackOffsets)
{
	const Outcome missed = run({"slice", "demo:shell:6", "--probe", "stack", "--offsets", "0", "100"});
	EXPECT_NE(missed.err.find("sheet 1 is empty"), std::string::npos) << missed.err;
	const json given = sheets({"--probe", "stack", "--offsets", "-2", "0.5", "1"});
	ASSERT_EQ(given.size(), 3u);
	EXPECT_DOUBLE_EQ(given[0].at("origin")[2].get<double>(), -2.0);
	EXPECT_DOUBLE_EQ(given[1].at("origin")[2].get<double>(), 0.5);
	EXPECT_DOUBLE_EQ(given[2].at("origin")[2].get<double>(), 1.0);

	const json even = sheets({"--probe", "stack", "--sheets", "3", "--normal", "x"});
	ASSERT_EQ(even.size(), 3u);
	for (int s = 0; s < 3; ++s)
		EXPECT_NEAR(even[s].at("origin")[0].get<double>(), -2.0 + 2.0 * s, kNear);
	EXPECT_EQ(sheets({"--probe", "stack"}).size(), 5u);
}

TEST_F(Probe, WorkFollowsTheWindow)
{
	const json whole = sheets({"--normal", "0.3", "0.5", "0.81"});
	const json small = sheets({"--normal", "0.3", "0.5", "0.81", "--window", "1", "0.5"});
	EXPECT_NEAR(small[0].at("area").get<double>(), 0.5, kNear);
	EXPECT_LT(small[0].at("cells_touched").get<int>(), whole[0].at("cells_touched").get<int>() / 8);
	EXPECT_GT(small[0].at("cut_cells").get<int>(), 0);
}

TEST_F(Probe, CornersOfTheWindowCanBeSkipped)
{
	const Arguments window{"--window", "2.1", "1.3", "--origin", "0.05", "0.13", "0.1"};
	const json keep = sheets(window + Arguments{"--corners", "keep"});
	const json skip = sheets(window + Arguments{"--corners", "skip"});
	EXPECT_EQ(keep, sheets(window));
	EXPECT_EQ(skip[0].at("polygons").get<int>(), keep[0].at("polygons").get<int>() - 4);
	EXPECT_LT(skip[0].at("area").get<double>(), keep[0].at("area").get<double>());
}

TEST_F(Probe, OfAFileWithArraysOfItsOwn)
{
	const std::string file = write("probe.json", R"({
		"to_probe": {"origin": [0, 0, 1]},
		"sheets": [{"window": [2, 2]}, {"to_sheet": {"normal": [1, 0, 0]}, "array": "v", "component": "x"},
		           {"to_sheet": {"origin": [0, 0, 1]}, "hidden": true}]})");
	const json cut = sheets({"--probe", file});
	ASSERT_EQ(cut.size(), 2u);
	EXPECT_EQ(cut[0].at("array"), "s");
	EXPECT_EQ(cut[1].at("array"), "v x");
	EXPECT_DOUBLE_EQ(cut[0].at("origin")[2].get<double>(), 1.0);
	EXPECT_NEAR(cut[0].at("area").get<double>(), 4.0, kNear);
	// v is (-y, x, 0.3): over the plane x = 0, v x = -y spans -3 to 3.
	EXPECT_NEAR(cut[1].at("min").get<double>(), -3.0, kNear);
	EXPECT_NEAR(cut[1].at("max").get<double>(), 3.0, kNear);

	const json moved = sheets({"--probe", file, "--origin", "0", "0", "-2"});
	EXPECT_DOUBLE_EQ(moved[0].at("origin")[2].get<double>(), -2.0);
}

TEST_F(Probe, SheetsAreTheSameAsEachAlone)
{
	const json together = sheets({"--probe", "trihedral", "--window", "2", "3"});
	const json alone = sheets({"--window", "2", "3"});
	for (const char* key : {"area", "cut_cells", "polygons", "vertices", "mean", "min", "max"})
		EXPECT_EQ(together[2].at(key), alone[0].at(key)) << key;
	EXPECT_GT(total(together, "area"), alone[0].at("area").get<double>());
}

TEST_F(Probe, TableTellsOfEverySheet)
{
	const Outcome outcome = run({"slice", "demo:blob:8", "--probe", "trihedral", "--classify", "cpu"});
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_GE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 4) << outcome.out;
}

TEST_P(BadProbeOption, IsOneLine)
{
	const auto& [arguments, word] = GetParam();
	EXPECT_TRUE(isError(run(Arguments{"slice", "demo:shell:4"} + arguments), 1, {word}));
	EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(Probes, BadProbeOption,
                         testing::Values(std::pair(Arguments{"--probe", "cube"}, "--probe cube"),
                                         std::pair(Arguments{"--window", "0", "1"}, "--window 0 1"),
                                         std::pair(Arguments{"--window", "1", "-1"}, "--window 1 -1"),
                                         std::pair(Arguments{"--window", "1", "nan"}, "--window 1 nan"),
                                         std::pair(Arguments{"--vanes", "3"}, "--vanes"),
                                         std::pair(Arguments{"--probe", "paddlewheel", "--vanes", "0"}, "--vanes"),
                                         std::pair(Arguments{"--probe", "paddlewheel", "--vanes", "65"}, "--vanes"),
                                         std::pair(Arguments{"--offsets", "1"}, "--offsets"),
                                         std::pair(Arguments{"--probe", "stack", "--offsets", "inf"}, "--offsets"),
                                         std::pair(Arguments{"--probe", "stack", "--offsets", "1", "--sheets", "2"},
                                                   "--sheets"),
                                         std::pair(Arguments{"--sheets", "2"}, "--sheets"),
                                         std::pair(Arguments{"--corners", "skip"}, "--corners"),
                                         std::pair(Arguments{"--corners", "round"}, "--corners"),
                                         std::pair(Arguments{"--up", "0", "0", "0"}, "--up"),
                                         std::pair(Arguments{"--origin", "0", "nan", "0"}, "--origin")));

TEST_F(Probe, FilesThatDoNotFit)
{
	const auto refused = [&](const std::string& text, const std::vector<std::string>& words)
	{
		const std::string file = write("probe.json", text);
		EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--probe", file}), 2, words)) << text;
	};
	refused("{\n\t\"sheets\": [,]\n}", {"probe.json", "line 2, column 13"});
	refused(R"({"sheets": []})", {"/sheets"});
	refused(R"({"sheets": [{"opacity": 1.5}]})", {"/sheets/0/opacity"});
	refused(R"({"sheets": [{"window": [0, 1]}]})", {"/sheets/0/window"});
	refused(R"({"sheets": [{}], "sheet": 1})", {"/sheet", "unknown key"});
	refused(R"({"sheets": [{"to_sheet": {"matrix": [[1,0,0,0],[0,1,0,0],[0,1,0,0],[0,0,0,1]]}}]})",
	        {"/sheets/0/to_sheet", "singular"});
	refused(R"({"sheets": [{"array": "depth"}]})", {"depth"});
	EXPECT_TRUE(isError(run({"slice", "demo:shell:4", "--probe", path("absent.json")}), 2, {"absent.json"}));
	EXPECT_TRUE(isError(
	    run({"slice", "demo:shell:4", "--probe", write("one.json", R"({"sheets": [{}]})"), "--window", "1", "1"}), 1,
	    {"--window", "of its own"}));
}

} // namespace cli
