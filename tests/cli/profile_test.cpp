#include "program.h"
#include "trace_check.h"

#include <algorithm>
#include <cmath>

namespace cli
{

namespace
{

class Profile : public Program
{
protected:
	nlohmann::json profile(const Arguments& options) const
	{
		const Outcome outcome = run(Arguments{"profile", "--json", "-", "--classify", "cpu"} + options);
		EXPECT_TRUE(isQuiet(outcome));
		nlohmann::json json = outcome.json();
		EXPECT_TRUE(json.is_object()) << outcome.out;
		return json;
	}
};

void expectSpread(const nlohmann::json& spread, const std::string& of)
{
	for (const char* key : {"first", "median", "p95", "noise"})
		ASSERT_TRUE(spread.contains(key) && spread[key].is_number()) << of << ": " << key << " " << spread;
	EXPECT_GT(spread["first"], 0.0) << of;
	EXPECT_GT(spread["median"], 0.0) << of;
	EXPECT_LE(spread["median"], spread["p95"]) << of;
	EXPECT_GE(spread["noise"], 0.0) << of;
}

nlohmann::json stageOf(const nlohmann::json& profile, const std::string& name)
{
	for (const auto& stage : profile.at("stages"))
		if (stage.at("stage") == name)
			return stage;
	return {};
}

} // namespace

TEST_F(Profile, PromisedKeys)
{
	for (const std::string demo : {"shell", "hexes", "tets", "blob", "graded", "mixed", "layer"})
	{
		const nlohmann::json told = profile({"demo:" + demo + ":6"});
		expectSpread(told.at("cut_ms"), demo);
		EXPECT_TRUE(told.at("frame_ms").is_null()) << demo;
		EXPECT_EQ(told.at("planes"), 60) << demo;
		EXPECT_GT(told.at("cut_cells_mean"), 10.0) << demo;
		EXPECT_GT(told.at("ns_per_cut_cell"), 0.0) << demo;
		EXPECT_NEAR(told.at("cells_per_second").get<double>() * told.at("ns_per_cut_cell").get<double>(), 1e9, 1.0);
		// Found without generations.
		EXPECT_EQ(told.at("generations_median"), 0.0) << demo;
		EXPECT_EQ(told.at("front_mean"), 0.0) << demo;
		EXPECT_EQ(told.at("classifier"), "cpu") << demo;
		for (const char* stage : {"frame", "cut", "seed", "traverse", "emit"})
			EXPECT_TRUE(stageOf(told, stage).is_object()) << demo << " " << stage;
	}
	EXPECT_EQ(profile({"demo:shell:6"}).at("finder"), "spans");
	EXPECT_EQ(profile({"demo:hexes:6"}).at("finder"), "flood");
}

TEST_F(Profile, MemoryIsWhatWasReadAndWhatWasBuilt)
{
	const auto shell = profile({"demo:shell:8"}).at("memory_bytes");
	EXPECT_EQ(shell.at("grid"), 9 * 9 * 9 * (3 + 4) * 4); // points, s and v
	const auto hexes = profile({"demo:hexes:8"}).at("memory_bytes");
	EXPECT_EQ(hexes.at("grid"), 9 * 9 * 9 * (3 + 4) * 4 + 8 * 8 * 8 * 8 * 4);
	for (const auto& memory : {shell, hexes})
	{
		std::size_t sum = 0;
		for (const auto& [name, bytes] : memory.at("parts").items())
			sum += bytes.get<std::size_t>();
		EXPECT_EQ(sum, memory.at("grid").get<std::size_t>() + memory.at("extra").get<std::size_t>());
		EXPECT_GT(memory.at("extra"), 0);
		EXPECT_GT(memory.at("peak_rss"), 1 << 20);
	}
}

// One plane of a sweep is what slice cuts there.
TEST_F(Profile, OnePlaneIsASlice)
{
	for (const std::string demo : {"demo:shell:16", "demo:tets:8"})
		for (const Arguments& probe :
		     {Arguments{"--normal", "1", "2", "3"}, Arguments{"--normal", "1", "2", "3", "--window", "2", "1.5"},
		      Arguments{"--probe", "trihedral", "--threshold", "-1", "0.5"}})
		{
			const auto told = profile(Arguments{demo, "--path", "spin", "--planes", "1"} + probe);
			// With a hot spot to look for, slice searches too.
			const auto sheets = stats(Arguments{demo, "--outside", "report"} + probe).at("sheets");
			std::size_t cut = 0, polygons = 0, vertices = 0, touched = 0, generations = 0, front_max = 0;
			for (const auto& sheet : sheets)
			{
				cut += sheet.at("linear_cut_cells").get<std::size_t>();
				polygons += sheet.at("polygons").get<std::size_t>();
				vertices += sheet.at("vertices").get<std::size_t>();
				touched += sheet.at("cells_touched").get<std::size_t>();
				generations = std::max(generations, sheet.at("generations").get<std::size_t>());
				front_max += sheet.at("front_max").get<std::size_t>();
			}
			EXPECT_EQ(told.at("sheets"), sheets.size());
			EXPECT_EQ(told.at("cut_cells_mean"), cut);
			EXPECT_EQ(told.at("polygons_mean"), polygons);
			EXPECT_EQ(told.at("vertices_mean"), vertices);
			EXPECT_EQ(told.at("cells_touched_mean"), touched);
			EXPECT_EQ(told.at("generations_median"), generations);
			EXPECT_EQ(told.at("generations").size(), generations);
			EXPECT_LE(told.at("front_max"), front_max); // sheets go in step: their widest need not meet
			std::size_t cells = 0;
			for (const auto& generation : told.at("generations"))
			{
				EXPECT_EQ(generation.at("planes"), 1);
				EXPECT_TRUE(generation.at("gpu_ms").is_null());
				cells += generation.at("cells").get<std::size_t>();
			}
			if (generations > 0)
			{
				EXPECT_EQ(cells, touched) << demo;
				EXPECT_NEAR(told.at("front_mean"), double(cells) / double(generations), 1e-6);
			}
		}
}

TEST_F(Profile, TheTableIsForPeople)
{
	const Outcome plain = run({"profile", "demo:shell:8", "--classify", "cpu"});
	ASSERT_TRUE(isQuiet(plain));
	for (const char* words : {"curvilinear, 512 cells", "60 planes along profile", "spans", "seed", "traverse", "emit",
	                          "first cut", "ns a cut cell", "as read", "resident"})
		EXPECT_TRUE(contains(plain.out, words)) << words << "\n" << plain.out;
	EXPECT_FALSE(contains(plain.out, "generations a plane"));

	const Outcome traversed = run({"profile", "demo:shell:8", "--classify", "cpu", "--visited", "stamps", "--planes",
	                               "5", "--json", path("p.json")});
	ASSERT_TRUE(isQuiet(traversed));
	EXPECT_TRUE(contains(traversed.out, "generations a plane")) << traversed.out;
	EXPECT_EQ(nlohmann::json::parse(contents(path("p.json"))).at("planes"), 5);
}

// The trace holds the times from which the figures are computed, to the nanosecond.
TEST_F(Profile, FiguresAreThoseOfTheTrace)
{
	const Outcome outcome = run({"profile", "demo:shell:16", "--classify", "cpu", "--planes", "21", "--visited",
	                             "stamps", "--json", path("p.json"), "--trace", path("t.json")});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = nlohmann::json::parse(contents(path("p.json")));
	std::vector<double> cuts;
	std::vector<double> fronts; // fronts of generation 0
	bool is_first = false;
	const trace::Rows rows = trace::check(contents(path("t.json")));
	for (const trace::Event& event : rows.named("main"))
	{
		const double ms = 1e-6 * static_cast<double>(event.end - event.begin);
		if (event.name == "cut")
			cuts.push_back(ms);
		if (event.name == "classify" && is_first)
			fronts.push_back(ms);
		is_first = event.name == "traverse" || (is_first && event.name != "classify");
	}
	ASSERT_EQ(cuts.size(), 21u);
	EXPECT_NEAR(told.at("cut_ms").at("first"), cuts[0], 2e-6);
	std::vector<double> off;
	for (std::size_t k = 1; k < 20; ++k)
		off.push_back(std::abs(cuts[k] - 0.5 * (cuts[k - 1] + cuts[k + 1])));
	std::ranges::sort(off);
	EXPECT_NEAR(told.at("cut_ms").at("noise"), off[9] * 1.4826 / std::sqrt(1.5), 1e-5);
	std::ranges::sort(cuts);
	EXPECT_NEAR(told.at("cut_ms").at("median"), cuts[10], 2e-6);
	EXPECT_NEAR(told.at("cut_ms").at("p95"), cuts[19], 2e-6); // 20 of 21 are 95 in 100
	EXPECT_NEAR(stageOf(told, "cut").at("median"), cuts[10], 2e-6);
	std::ranges::sort(fronts);
	const auto& generation = told.at("generations").at(0);
	ASSERT_EQ(generation.at("planes"), fronts.size());
	EXPECT_NEAR(generation.at("classify_ms"), 0.5 * (fronts[fronts.size() / 2] + fronts[(fronts.size() - 1) / 2]),
	            2e-6);
}

TEST_F(Profile, StagesHaveFaultsAndInstructionsOrAReason)
{
	const auto told = profile({"demo:shell:16", "--planes", "5"});
	const auto& missing = told.at("not_counted");
	EXPECT_FALSE(missing.contains("pipelines")); // there is no device
	EXPECT_FALSE(told.contains("pipelines"));
	const bool counts = !missing.contains("instructions");
	for (const auto& stage : told.at("stages"))
	{
		EXPECT_GE(stage.at("page_faults"), 0.0);
		EXPECT_GE(stage.at("major_faults"), 0.0);
		EXPECT_EQ(stage.at("instructions").is_number(), counts) << stage;
		EXPECT_EQ(stage.at("cache_misses").is_number(), counts) << stage;
	}
	if (counts)
	{
		EXPECT_GT(stageOf(told, "emit").at("instructions"), told.at("polygons_mean")); // at least one for each
	}
	const Outcome table = run({"profile", "demo:shell:16", "--classify", "cpu", "--planes", "2"});
	ASSERT_TRUE(isQuiet(table));
	EXPECT_TRUE(contains(table.out, "faults")) << table.out;
	EXPECT_EQ(contains(table.out, "instructions are not told: "), !counts) << table.out;
	const auto without = profile({"demo:shell:16", "--planes", "2", "--no-floor"});
	EXPECT_FALSE(without.contains("not_counted"));
	EXPECT_FALSE(stageOf(without, "emit").contains("page_faults"));
}

// By hand: the plane z = 0 cuts an image of 7 x 7 x 7 cells in 49 squares with 64 vertices. Nothing is read of the
// grid. There are 8 spans of 28 bytes, a row of cells each and one for the last points, and 64 columns of 2 bytes. They
// are written twice: in the list of a part, which leaves half as much memory behind as it grows, and in the cut. A
// number of 4 bytes tells where the signs of each of the 64 rows of points change.
//
// A vertex has three coordinates and the place on its edge, of 24 bytes each. A square has 4 numbers of vertices and an
// offset, of 4 bytes each, and its cell, of 8 bytes; one more offset ends the list. The spans and columns are read
// again, and each column has the numbers of its vertices, 16 bytes.
TEST_F(Profile, LinesAndTimesOfTheFloor)
{
	const auto told = profile({"demo:blob:7", "--normal", "0", "0", "1", "--path", "spin", "--planes", "1"});
	ASSERT_EQ(told.at("vertices_mean"), 64.0);
	ASSERT_EQ(told.at("polygons_mean"), 49.0);
	const auto linesOf = [](int bytes) { return (bytes + 63) / 64; };
	const auto traverse = stageOf(told, "traverse");
	EXPECT_EQ(traverse.at("lines"), linesOf(5 * (8 * 28 + 2 * 64) / 2 + 4 * 64));
	EXPECT_EQ(traverse.at("runs"), 1);
	const auto emit = stageOf(told, "emit");
	EXPECT_EQ(emit.at("lines"), linesOf(8 * 28 + (2 + 16) * 64) + linesOf(64 * (24 + 24) + 49 * (4 * 4 + 4 + 8) + 4));
	EXPECT_EQ(emit.at("runs"), 2);
	EXPECT_EQ(emit.at("bytes").get<double>(), 64 * emit.at("lines").get<double>());
	const double bytes_per_ms = 1e-3 * told.at("floor").at("bytes_per_second").get<double>();
	EXPECT_GT(bytes_per_ms, 1e5); // no memory is slower than 0.1 GB a second
	const double random_ms = 1e-6 * told.at("floor").at("line_ns").get<double>();
	EXPECT_NEAR(emit.at("floor_ms").get<double>(),
	            2 * random_ms + 64 * (emit.at("lines").get<double>() - 2) / bytes_per_ms, 1e-9);
	EXPECT_NEAR(emit.at("times_floor").get<double>() * emit.at("floor_ms").get<double>(),
	            emit.at("median").get<double>(), 1e-6);
	EXPECT_TRUE(stageOf(told, "seed").at("bytes").is_null());
	EXPECT_TRUE(told.at("floor").at("submit_ms").is_null()); // no device
	for (const auto& stage : told.at("stages"))
	{
		EXPECT_GE(stage.at("cpu_ms"), 0.0);
		EXPECT_TRUE(stage.at("bound_by").is_string());
	}
	EXPECT_GT(stageOf(told, "frame").at("cpu_ms"), 0.0);

	const auto without = profile({"demo:hexes:6", "--no-floor", "--planes", "2"});
	EXPECT_FALSE(without.contains("floor"));
	EXPECT_FALSE(stageOf(without, "emit").contains("cpu_ms"));
	const Outcome table = run({"profile", "demo:hexes:6", "--classify", "cpu", "--planes", "2"});
	ASSERT_TRUE(isQuiet(table));
	for (const char* words : {"cores", "floor", "this machine", "GB a second", "a random line", "longest: "})
		EXPECT_TRUE(contains(table.out, words)) << words << "\n" << table.out;
}

TEST_F(Profile, PlanesThatMissTheGridAreTold)
{
	const Outcome outcome = run({"profile", "demo:shell:6", "--classify", "cpu", "--origin", "50", "0", "0", "--normal",
	                             "x", "--path", "spin", "--planes", "3", "--json", "-"});
	EXPECT_TRUE(isDoneWithAWord(outcome, {"3 of 3 planes are empty"}));
	EXPECT_EQ(outcome.json().at("ns_per_cut_cell"), 0.0);
	EXPECT_EQ(outcome.json().at("empty_planes"), 3);
}

TEST_F(Profile, StatesAndSurfaces)
{
	ASSERT_TRUE(isQuiet(run({"slice", "demo:shell:8", "--classify", "cpu", "--normal", "x", "--window", "1", "1",
	                         "--save", path("s.json")})));
	const auto kept = profile({"--state", path("s.json"), "--planes", "4"});
	EXPECT_EQ(kept.at("path"), "profile");
	EXPECT_EQ(kept.at("input"), "demo:shell:8");
	EXPECT_EQ(kept.at("cut_cells_mean"),
	          profile({"demo:shell:8", "--normal", "x", "--window", "1", "1", "--planes", "4"}).at("cut_cells_mean"));
	const auto surface = profile({"demo:shell:8", "--surface", "i=0..8", "--path", "translate", "--planes", "3"});
	EXPECT_EQ(surface.at("cut_cells_mean"), 64.0);
	EXPECT_EQ(surface.at("finder"), "subscripts");
	EXPECT_EQ(surface.at("surface"), "i=0..8");
}

TEST_F(Profile, WrongUsage)
{
	const auto refused = [&](const Arguments& arguments, const std::vector<std::string>& words)
	{
		EXPECT_TRUE(isError(run(Arguments{"profile"} + arguments), 1, words)) << testing::PrintToString(arguments);
		EXPECT_TRUE(files().empty());
	};
	refused({}, {"INPUT"});
	refused({"demo:shell:4", "--json", "-", "--trace", "-"}, {"--json -", "--trace -"});
	refused({"demo:shell:4", "--planes", "0"}, {"--planes"});
	refused({"demo:shell:4", "--planes", "10001"}, {"--planes"});
	refused({"demo:shell:4", "--path", "times"}, {"--path times"});
	refused({"demo:shell:4", "--path", "loop"}, {"--path loop"});
	refused({"demo:shell:4", "--bands", "3"}, {"--bands", "--draw"});
	refused({"demo:shell:4", "--surface", "i=2"}, {"--path profile", "--surface"});
	refused({"--compare", "a.json"}, {"--compare"});
	refused({"demo:shell:4", "--compare", "a.json", "b.json"}, {"--compare", "leave one"});
	refused({"--compare", "a.json", "b.json", "--json", "-"}, {"--json", "--compare"});
}

TEST_F(Profile, PlacesThatCannotBeAreToldAtOnce)
{
	write("none", "a file where the folder would be");
	for (const char* option : {"--json", "--trace", "--save"})
		EXPECT_TRUE(isError(run({"profile", "demo:shell:4", "--classify", "cpu", option, path("none/p.json")}), 4,
		                    {"none/p.json"}))
		    << option;
	EXPECT_TRUE(isError(run({"profile", path("none.vtk")}), 2, {"none.vtk"}));
	EXPECT_EQ(files(), Arguments{"none"});
}

TEST_F(Profile, InterruptedItLeavesNothing)
{
	const Outcome outcome = interrupted({"profile", "demo:shell:32", "--classify", "cpu", "--planes", "10000", "--json",
	                                     path("p.json"), "--trace", path("t.json")},
	                                    [&] { return !files().empty(); });
	EXPECT_EQ(outcome.status, 130) << outcome.err;
	EXPECT_TRUE(files().empty()) << files().front();
}

} // namespace cli
