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
	// A device without timestamps has neither row.
	EXPECT_EQ(rows.named("GPU cut").empty(), rows.named("GPU draw").empty());
}

} // namespace cli
