// Where the time of a window goes: the trace of --trace, and the stages of --stats.

#include "desktop.h"
#include "trace_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace view
{

namespace
{

class TraceOfTheWindow : public Desktop
{
protected:
	static constexpr int kMoves = 12;

	void move()
	{
		for (int i = 0; i < kMoves; ++i)
		{
			act(i % 2 == 0 ? "push_forward" : "turn_up_plus");
			command("wait");
		}
		settle();
	}
};

bool holds(const trace::Event& outer, const trace::Event& inner)
{
	return outer.begin <= inner.begin && inner.end <= outer.end;
}

} // namespace

TEST_F(TraceOfTheWindow, HasAllThreadsOnOneAxis)
{
	open({"demo:tets:24", "--normal", "0.3", "0.5", "0.8", "--trace", path("t.json")});
	move();
	close();
	const trace::Rows rows = trace::check(cli::contents(path("t.json")));

	const auto& window = rows.named("main");
	const auto& drawing = rows.named("render");
	std::set<std::string> setup;
	std::set<int> shown; // numbers of the pictures that frames of the window brought
	std::set<int> made;
	int interfaces = 0;
	for (const trace::Event& event : window)
	{
		if (event.category == "setup")
			setup.insert(event.name);
		if (event.name == "window frame" && event.frame >= 0)
			shown.insert(event.frame);
		if (event.name == "interface" || event.name == "present")
		{
			++interfaces;
			EXPECT_TRUE(std::ranges::any_of(window, [&](const trace::Event& outer)
			                                { return outer.name == "window frame" && holds(outer, event); }));
		}
	}
	EXPECT_TRUE(setup.contains("open device") && setup.contains("Vulkan instance") && setup.contains("Vulkan device"));
	EXPECT_GT(interfaces, 2 * kMoves);
	for (const trace::Event& event : drawing)
		if (event.name == "frame")
			made.insert(event.frame);
	EXPECT_GE(made.size(), std::size_t(kMoves));
	EXPECT_TRUE(std::ranges::includes(made, shown));
	EXPECT_GE(shown.size(), std::size_t(kMoves));
	EXPECT_FALSE(rows.named("loader").empty());

	// A picture is made before the window shows it.
	for (const trace::Event& event : window)
		if (event.name == "window frame" && event.frame >= 0)
		{
			EXPECT_TRUE(std::ranges::any_of(drawing,
			                                [&](const trace::Event& made_before) {
				                                return made_before.name == "frame" &&
				                                       made_before.frame == event.frame &&
				                                       made_before.begin <= event.begin;
			                                }));
		}

	EXPECT_GE(rows.flows.size(), std::size_t(kMoves));
	for (const auto& [frame, points] : rows.flows)
	{
		EXPECT_TRUE(made.contains(frame));
		EXPECT_EQ(points.front().row, "render");
		EXPECT_EQ(points.front().event, "cut");
		EXPECT_EQ(points.back().event, "render");
	}
	EXPECT_FALSE(rows.counters.at("resident memory").empty());
	EXPECT_EQ(rows.about.at("input"), "demo:tets:24");
	EXPECT_TRUE(cli::contains(rows.about.at("command_line"), "view demo:tets:24"));
	EXPECT_NE(rows.about.at("device"), "none");
	EXPECT_NE(rows.about.at("driver"), "none");
}

TEST_F(TraceOfTheWindow, OfTheLastMinuteNeedsNoOption)
{
	open({"demo:tets:12"});
	move();
	command("save-trace " + path("t.json"));
	settle();
	close();
	const trace::Rows rows = trace::check(cli::contents(path("t.json")));
	for (const char* row : {"main", "render"})
	{
		EXPECT_FALSE(rows.named(row).empty()) << row;
	}
	EXPECT_TRUE(rows.flows.empty()); // these cost time
	EXPECT_EQ(rows.about.at("input"), "demo:tets:12");
}

// By the same names as in a profile.
TEST_F(TraceOfTheWindow, TheStagesAreThoseOfAProfile)
{
	const cli::Arguments input{"demo:tets:24", "--normal", "0.3", "0.5", "0.8", "--classify", "cpu"};
	open(input);
	move();
	act("profile_overlay");
	settle();
	const nlohmann::json stats = close();
	const cli::Outcome profile =
	    run(cli::Arguments{"profile"} + input + cli::Arguments{"--planes", "3", "--draw", "--no-floor", "--json", "-"});
	ASSERT_EQ(profile.status, 0) << profile.err;
	const nlohmann::json document = profile.json();
	std::set<std::string> known;
	for (const auto& stage : document.at("stages"))
		known.insert(stage.at("stage"));
	for (const auto& stage : document.at("gpu_stages"))
		known.insert("gpu " + stage.at("stage").get<std::string>());
	std::set<std::string> told;
	double whole = 0.0, parts = 0.0;
	for (const auto& stage : stats.at("stages"))
	{
		const std::string name = stage.at("stage");
		EXPECT_TRUE(told.insert(name).second) << name;
		EXPECT_TRUE(known.contains(name)) << name;
		EXPECT_GE(stage.at("median").get<double>(), 0.0);
		if (name == "frame")
			whole = stage.at("median");
		if (name == "cut" || name == "render")
			parts += stage.at("median").get<double>();
	}
	for (const char* stage :
	     {"frame", "cut", "seed", "traverse", "emit", "measure", "render", "scene", "draw", "gpu layers"})
	{
		EXPECT_TRUE(told.contains(stage)) << stage;
	}
	EXPECT_GT(whole, 0.0);
	EXPECT_GT(parts, 0.5 * whole);
	EXPECT_LT(parts, 1.2 * whole); // medians of parts add up only roughly
}

} // namespace view
