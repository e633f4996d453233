#include "program.h"

#include <algorithm>

namespace cli
{

namespace
{

class Explain : public Program
{
};

} // namespace

TEST_F(Explain, TellsTheWayOfEachSheetInEachBlockAndEnds)
{
	const Outcome told = run({"slice", "demo:shell:8", "--probe", "trihedral", "--explain", "-o", path("out.vtp"),
	                          "--stats", path("s.json")},
	                         noDevice());
	ASSERT_TRUE(isQuiet(told));
	EXPECT_TRUE(told.out.starts_with("sheet  block")) << told.out;
	EXPECT_EQ(std::count(told.out.begin(), told.out.end(), '\n'), 4) << told.out;
	EXPECT_TRUE(contains(told.out, "spans        cpu         curvilinear")) << told.out;
	EXPECT_TRUE(files().empty());
}

TEST_F(Explain, IsOfFourCommandsAndNeedsNoOutput)
{
	const std::string told = run({"slice", "demo:blob:8", "--window", "1", "1", "--explain"}).out;
	EXPECT_TRUE(contains(told, "rows")) << told;
	for (const std::string command : {"render", "sweep", "profile"})
		EXPECT_EQ(run({command, "demo:blob:8", "--window", "1", "1", "--explain"}, noDevice()).out, told) << command;
	EXPECT_TRUE(isError(run({"view", "demo:blob:8", "--explain"}), 1, {"--explain"}));
	EXPECT_TRUE(contains(run({"render", "demo:blob:8", "--color-by", "generation", "--explain"}).out, "generations"));
}

TEST_F(Explain, StandsInTheFigures)
{
	const nlohmann::json plan = stats({"demo:tets:6", "--probe", "paddlewheel", "--vanes", "2"})["plan"];
	ASSERT_EQ(plan.size(), 2u);
	for (std::size_t s = 0; s < 2; ++s)
	{
		EXPECT_EQ(plan[s]["sheet"], s);
		EXPECT_EQ(plan[s]["block"], 0);
		EXPECT_EQ(plan[s]["strategy"], "scan");
		EXPECT_EQ(plan[s]["classifier"], "cpu");
		EXPECT_TRUE(contains(plan[s]["reason"].get<std::string>(), "looked at once"));
	}
}

TEST_F(Explain, AStrategyAskedForFindsTheSameCells)
{
	for (const auto& [demo, fastest] : {std::pair<std::string, std::string>("blob", "rows"),
	                                    {"graded", "rows"},
	                                    {"shell", "spans"},
	                                    {"mixed", "cells"}})
	{
		const Arguments input{"demo:" + demo + ":12", "--normal", "0.3", "0.5", "0.81", "--strategy"};
		const nlohmann::json named = stats(input + Arguments{fastest});
		const nlohmann::json generations = stats(input + Arguments{"generations"});
		EXPECT_EQ(named["plan"][0]["strategy"], fastest);
		EXPECT_EQ(named["sheets"][0]["generations"], 0);
		EXPECT_EQ(generations["plan"][0]["reason"], "asked for");
		EXPECT_GT(generations["sheets"][0]["generations"], 0);
		for (const char* key : {"cut_cells", "polygons", "vertices", "area"})
			EXPECT_EQ(named["sheets"][0][key], generations["sheets"][0][key]) << demo << ' ' << key;
	}
}

TEST_F(Explain, AStrategyThatCannotBeHadIsRefused)
{
	for (const Arguments& more : {Arguments{"-o", path("out.vtp")}, Arguments{"--explain"}})
		EXPECT_TRUE(isError(run(Arguments{"slice", "demo:shell:8", "--classify", "cpu", "--strategy", "rows"} + more),
		                    1, {"--strategy rows", "shell", "no straight axes", "spans"}));
	EXPECT_TRUE(
	    isError(run({"slice", "demo:shell:8", "--strategy", "spans", "--visited", "octants", "--classify", "cpu"}), 1,
	            {"--strategy spans", "generations"}));
	EXPECT_TRUE(isError(run({"slice", "demo:shell:8", "--strategy", "guess"}), 1, {"--strategy"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
