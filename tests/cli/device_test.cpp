#include "program.h"

namespace cli
{

namespace
{

// Skipped where there is no device.
class Device : public Program
{
protected:
	void SetUp() override
	{
		const Outcome outcome = run({"slice", "demo:shell:4", "--classify", "gpu", "--stats", "-"});
		if (outcome.status == 3)
			GTEST_SKIP() << outcome.err;
	}
	Outcome slice(const Arguments& options) const
	{
		return run(Arguments{"slice", "demo:shell:16", "--stats", "-"} + options);
	}
};

} // namespace

TEST_F(Device, StatsNameIt)
{
	const Outcome outcome = slice({"--classify", "gpu"});
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_TRUE(outcome.json()["classifier"] == "gpu" || outcome.json()["classifier"] == "mixed") << outcome.out;
	EXPECT_TRUE(outcome.json()["device"].is_string() && !outcome.json()["device"].empty());
}

TEST_F(Device, GivesWhatTheCpuGives)
{
	for (const std::string demo : {"shell", "hexes", "tets", "blob", "graded", "mixed", "layer"})
	{
		const Arguments probe{"slice", "demo:" + demo + ":8", "--normal", "0.3", "0.5", "0.81", "--stats", "-"};
		const nlohmann::json gpu = run(probe + Arguments{"--classify", "gpu"}).json()["sheets"][0];
		const nlohmann::json cpu = run(probe + Arguments{"--classify", "cpu"}).json()["sheets"][0];
		for (const char* key : {"cut_cells", "polygons", "vertices", "components"})
			EXPECT_EQ(gpu[key], cpu[key]) << demo << " " << key;
		EXPECT_NEAR(gpu["area"], cpu["area"], 1e-5 * cpu["area"].get<double>()) << demo;
		EXPECT_NEAR(gpu["mean"], cpu["mean"], 1e-5) << demo;
	}
}

// A sheet in the boundary, below all cells.
TEST_F(Device, GivesWhatTheCpuGivesInTheBoundary)
{
	for (const std::string demo : {"blob", "graded", "mixed"})
	{
		const Arguments probe{"slice", "demo:" + demo + ":8", "--origin", "0",       "0", "-3", "--normal",
		                      "z",     "--vector-array",      "v",        "--stats", "-"};
		const nlohmann::json gpu = run(probe + Arguments{"--classify", "gpu"}).json()["sheets"][0];
		const nlohmann::json cpu = run(probe + Arguments{"--classify", "cpu"}).json()["sheets"][0];
		for (const char* key : {"boundary_area", "boundary_mean", "boundary_flux", "area", "flux", "boundary_faces"})
			EXPECT_EQ(gpu[key], cpu[key]) << demo << " " << key;
		EXPECT_NEAR(gpu["boundary_area"], 36.0, 1e-5) << demo;
		EXPECT_NEAR(gpu["boundary_flux"], 0.3 * 36.0, 1e-4) << demo; // v = (-y, x, 0.3)
	}
}

TEST_F(Device, HotSpotsOverTheSheetLeaveFewGenerations)
{
	const Arguments probe{"slice", "demo:hexes:48", "--normal", "0.3",     "0.5",
	                      "0.81",  "--classify",    "gpu",      "--stats", "-"};
	const nlohmann::json spread = run(probe).json()["sheets"][0];
	const nlohmann::json plain = run(probe + Arguments{"--visited", "stamps"}).json()["sheets"][0];
	for (const char* key : {"cut_cells", "polygons", "vertices", "components", "cells_touched"})
		EXPECT_EQ(spread[key], plain[key]) << key;
	EXPECT_LE(spread["generations"], 24);
	EXPECT_GT(plain["generations"], 24);
	EXPECT_LE(spread["hops"], 0.2 * spread["cut_cells"].get<double>() + 6.0 * 48);
}

TEST_F(Device, WithoutTheOptionOrWithAuto)
{
	EXPECT_TRUE(isQuiet(slice({})));
	EXPECT_TRUE(isQuiet(slice({"--classify", "auto"})));
	// A device of software, even one that is asked for by name, is given nothing that it does not draw.
	const nlohmann::json named = slice({"--device", slice({"--classify", "gpu"}).json()["device"]}).json();
	if (contains(named["device"].get<std::string>(), "llvmpipe"))
	{
		EXPECT_EQ(named["classifier"], "cpu");
		EXPECT_EQ(named["ms"]["upload"], 0.0);
	}
}

TEST_F(Device, AutoTellsFromWhereTheDeviceIsFaster)
{
	const nlohmann::json stats = slice({"--classify", "auto"}).json();
	ASSERT_TRUE(stats.contains("break_even_cells"));
	const nlohmann::json& cells = stats["break_even_cells"];
	// 16^2 cells are less than the narrowest front that is measured.
	EXPECT_TRUE(cells.is_null() || cells >= 2048) << cells;
	EXPECT_EQ(stats["classifier"], "cpu");
	for (const char* named : {"cpu", "gpu"})
		EXPECT_TRUE(slice({"--classify", named}).json()["break_even_cells"].is_null());
}

TEST_F(Device, ByIndexOrName)
{
	EXPECT_TRUE(isQuiet(slice({"--classify", "gpu", "--device", "0"})));
	const std::string name = slice({"--classify", "gpu"}).json()["device"];
	EXPECT_TRUE(isQuiet(slice({"--classify", "gpu", "--device", name.substr(0, name.find(' '))})));
}

TEST_F(Device, OneThatIsNotThere)
{
	for (const std::string device : {"99", "no-such-device"})
		EXPECT_TRUE(isError(slice({"--classify", "gpu", "--device", device}), 3, {device}));
}

TEST_F(Device, OutputsOfTheGpu)
{
	for (const std::string output : {"out.vtp", "out.ply", "out.csv"})
	{
		EXPECT_TRUE(isQuiet(run({"slice", "demo:shell:16", "--classify", "gpu", "-o", path(output)})));
		EXPECT_FALSE(contents(path(output)).empty());
	}
}

TEST_F(Device, PlaneThatMissesTheGrid)
{
	const Outcome outcome = slice({"--classify", "gpu", "--origin", "100", "0", "0", "--normal", "x"});
	EXPECT_TRUE(isDoneWithAWord(outcome, {"empty"}));
	EXPECT_EQ(outcome.json()["sheets"][0]["cut_cells"], 0);
}

} // namespace cli
