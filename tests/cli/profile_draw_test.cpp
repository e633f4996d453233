#include "program.h"
#include "trace_check.h"

namespace cli
{

namespace
{

class ProfileOnDevice : public Drawing
{
};

// The event of the row in whose time, give or take a millisecond, another one lies.
bool liesInOne(const trace::Event& event, const std::vector<trace::Event>& row, const std::string& name)
{
	constexpr std::int64_t kSlack = 1'000'000; // ns; the clocks agree to well below
	return std::ranges::any_of(
	    row, [&](const trace::Event& outer)
	    { return outer.name == name && event.begin >= outer.begin - kSlack && event.end <= outer.end + kSlack; });
}

} // namespace

TEST_F(ProfileOnDevice, WholeFrames)
{
	const Outcome outcome = run({"profile", "demo:shell:12", "--draw", "--planes", "4", "--size", "96x64", "--samples",
	                             "2", "--classify", "cpu", "--json", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = outcome.json();
	EXPECT_EQ(told.at("picture"), "96x64, 2 samples");
	EXPECT_GT(told.at("frame_ms").at("median"), told.at("cut_ms").at("median"));
	EXPECT_GT(told.at("frame_ms").at("first"), 0.0);
	std::vector<std::string> stages;
	for (const auto& stage : told.at("stages"))
		stages.push_back(stage.at("stage"));
	for (const char* stage : {"frame", "cut", "measure", "render", "draw", "wait"})
		EXPECT_TRUE(std::ranges::count(stages, stage) == 1) << stage;
	for (const auto& stage : told.at("gpu_stages"))
		EXPECT_GE(stage.at("median"), 0.0);
	for (const auto& stage : told.at("stages"))
	{
		if (stage.at("stage") == "pixels")
		{
			EXPECT_EQ(stage.at("bytes"), 96 * 64 * 4);
		}
		// Not less than an empty submission.
		if (stage.at("stage") == "wait")
		{
			EXPECT_GE(stage.at("floor_ms"), told.at("floor").at("submit_ms"));
			EXPECT_EQ(stage.at("bound_by"), "device");
		}
	}
	EXPECT_GT(told.at("floor").at("submit_ms"), 0.0);
	EXPECT_GT(told.at("floor").at("pixels_per_second"), 1e5);
	const Outcome table = run({"profile", "demo:shell:12", "--draw", "--planes", "2", "--size", "96x64"});
	ASSERT_TRUE(isQuiet(table));
	EXPECT_TRUE(contains(table.out, "96x64, 8 samples")) << table.out;
	EXPECT_TRUE(contains(table.out, "compose")) << table.out;
	EXPECT_TRUE(contains(table.out, "first frame")) << table.out;
}

TEST_F(ProfileOnDevice, GenerationsHaveTimesOfBoth)
{
	const Outcome outcome = run({"profile", "demo:shell:16", "--classify", "gpu", "--planes", "5", "--json", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = outcome.json();
	EXPECT_EQ(told.at("classifier"), "gpu");
	EXPECT_EQ(told.at("finder"), "traversal");
	EXPECT_GT(told.at("generations_median"), 1.0);
	EXPECT_GT(told.at("memory_bytes").at("parts").at("device"), 0);
	for (const auto& generation : told.at("generations"))
	{
		EXPECT_GT(generation.at("classify_ms"), 0.0);
		if (!generation.at("gpu_ms").is_null())
		{
			EXPECT_LE(generation.at("gpu_ms").get<double>(), generation.at("classify_ms").get<double>() + 1.0);
		}
	}
}

// A front is classified by groups of 64, the last of which may have more runs than cells.
TEST_F(ProfileOnDevice, ClassifyRunsOnceForEachCell)
{
	const Outcome outcome = run({"profile", "demo:shell:16", "--classify", "gpu", "--planes", "1", "--json",
	                             path("p.json"), "--trace", path("t.json")});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = nlohmann::json::parse(contents(path("p.json")));
	if (told.at("not_counted").contains("invocations"))
		GTEST_SKIP() << told.at("not_counted").at("invocations");
	constexpr std::uint64_t kGroup = 64;
	std::uint64_t runs = 0;
	const trace::Rows rows = trace::check(contents(path("t.json")));
	for (const trace::Event& event : rows.named("main"))
		if (event.name == "classify")
			runs += (event.cells + kGroup - 1) / kGroup * kGroup;
	EXPECT_GT(runs, told.at("cells_touched_mean").get<std::uint64_t>());
	ASSERT_EQ(told.at("gpu_stages").size(), 1u);
	const auto& classify = told.at("gpu_stages").at(0);
	EXPECT_EQ(classify.at("computes"), static_cast<double>(runs));
	EXPECT_EQ(classify.at("vertices"), 0.0);
	EXPECT_EQ(classify.at("fragments"), 0.0);
}

TEST_F(ProfileOnDevice, PassesOfAPictureCountTheirShaders)
{
	const Arguments options{"profile", "demo:shell:12", "--draw", "--planes",   "2",  "--size",
	                        "96x64",   "--samples",     "1",      "--classify", "cpu"};
	const Outcome outcome = run(options + Arguments{"--json", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = outcome.json();
	if (told.at("not_counted").contains("invocations"))
		GTEST_SKIP() << told.at("not_counted").at("invocations");
	for (const auto& stage : told.at("gpu_stages"))
		if (stage.at("stage") == "compose")
		{
			EXPECT_EQ(stage.at("vertices"), 3.0); // one triangle over the whole picture
			EXPECT_GE(stage.at("fragments"), 96.0 * 64.0);
			EXPECT_LE(stage.at("fragments"), 2.0 * 96.0 * 64.0); // pixels beside edges may run too
			EXPECT_EQ(stage.at("computes"), 0.0);
		}
	const Outcome table = run(options);
	ASSERT_TRUE(isQuiet(table));
	EXPECT_TRUE(contains(table.out, "shaders a plane")) << table.out;
	// A line tells what a driver lacks; what it has is told shader by shader.
	EXPECT_EQ(told.at("pipelines").is_null(), told.at("not_counted").contains("pipelines"));
	EXPECT_EQ(contains(table.out, "pipelines are not told: "), told.at("pipelines").is_null()) << table.out;
	EXPECT_EQ(contains(table.out, "pipeline compose, "), !told.at("pipelines").is_null()) << table.out;
}

TEST_F(ProfileOnDevice, TraceHasBothOnOneAxis)
{
	ASSERT_TRUE(isQuiet(run({"profile", "demo:shell:16", "--classify", "gpu", "--draw", "--planes", "6", "--size",
	                         "96x64", "--trace", path("t.json")})));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	const auto& main = rows.named("main");
	int frames = 0;
	for (const trace::Event& event : main)
		if (event.name == "frame")
		{
			++frames;
			trace::expectWhole(main, event);
		}
	EXPECT_EQ(frames, 6);
	for (const trace::Event& event : rows.named("GPU cut"))
	{
		EXPECT_EQ(event.category, "gpu");
		EXPECT_TRUE(liesInOne(event, main, "traverse")) << event.begin;
	}
	for (const trace::Event& event : rows.named("GPU draw"))
		EXPECT_TRUE(liesInOne(event, main, "wait")) << event.name << event.begin;
	EXPECT_EQ(rows.flows.size(), 6u);
	for (const auto& [frame, points] : rows.flows)
	{
		EXPECT_EQ(points.front().event, "cut") << frame;
		EXPECT_EQ(points.back().event, "render") << frame;
	}
	// A device without timestamps has neither row.
	EXPECT_EQ(rows.named("GPU cut").empty(), rows.named("GPU draw").empty());
}

} // namespace cli
