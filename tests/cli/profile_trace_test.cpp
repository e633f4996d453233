#include "program.h"
#include "trace_check.h"

#include <algorithm>
#include <iterator>
#include <thread>

namespace cli
{

namespace
{

class ProfileTrace : public Program
{
};

} // namespace

TEST_F(ProfileTrace, FollowsItsFormatAndAddsUp)
{
	for (const Arguments& probe :
	     {Arguments{}, Arguments{"--probe", "trihedral", "--window", "3", "3", "--visited", "octants"}})
	{
		const Outcome outcome = run(
		    Arguments{"profile", "demo:shell:24", "--classify", "cpu", "--planes", "20", "--trace", path("t.json")} +
		    probe);
		ASSERT_TRUE(isQuiet(outcome));
		const trace::Rows rows = trace::check(contents(path("t.json")));
		const auto& events = rows.named("main");
		std::map<std::string, int> count;
		for (const trace::Event& event : events)
		{
			++count[event.name];
			EXPECT_EQ(event.category, "cpu");
			if (event.name == "frame" || event.name == "cut")
				trace::expectWhole(events, event);
		}
		EXPECT_EQ(count["frame"], 20);
		EXPECT_EQ(count["cut"], 20);
		EXPECT_EQ(count["seed"], 20);
		EXPECT_GE(count["build"], 1);
		EXPECT_EQ(count["classify"] > 0, !probe.empty());
		EXPECT_EQ(count["classify"], count["expand"]);
	}
	EXPECT_EQ(files(), Arguments{"t.json"});
}

// The counter holds the width of each front until the next one.
TEST_F(ProfileTrace, FrontsOfTheTraceAreTheCellsThatWereMet)
{
	const Outcome outcome =
	    run({"profile", "demo:shell:16", "--classify", "cpu", "--planes", "9", "--probe", "trihedral", "--visited",
	         "stamps", "--no-floor", "--json", path("p.json"), "--trace", path("t.json")});
	ASSERT_TRUE(isQuiet(outcome));
	const auto told = nlohmann::json::parse(contents(path("p.json")));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	std::uint64_t met = 0;
	std::map<std::int64_t, std::uint64_t> by_time;
	for (const trace::Count& count : rows.counters.at("front"))
	{
		met += count.value;
		by_time[count.at] = count.value;
	}
	EXPECT_GT(met, 1000u);
	EXPECT_NEAR(told.at("cells_touched_mean").get<double>() * 9.0, static_cast<double>(met),
	            1e-6 * static_cast<double>(met));
	EXPECT_EQ(std::ranges::count(rows.counters.at("front"), 0u, &trace::Count::value), 9); // the ends of the searches
	std::uint64_t in_events = 0;
	for (const trace::Event& event : rows.named("main"))
		if (event.name == "classify")
		{
			in_events += event.cells;
			const auto last = by_time.upper_bound(event.begin);
			ASSERT_TRUE(last != by_time.begin());
			EXPECT_EQ(std::prev(last)->second, event.cells);
		}
	EXPECT_EQ(in_events, met);
}

// The rows of workers lie within the sections that gave them work.
TEST_F(ProfileTrace, ShowsTheWorkers)
{
	const Arguments options{"profile", "demo:tets:40", "--classify", "cpu", "--no-floor", "--trace", path("t.json")};
	ASSERT_TRUE(isQuiet(run(options + Arguments{"--threads", "1", "--planes", "2"})));
	EXPECT_TRUE(trace::check(contents(path("t.json"))).named("worker 1").empty());
	if (std::thread::hardware_concurrency() < 2)
		GTEST_SKIP() << "one core has no workers";
	ASSERT_TRUE(isQuiet(run(options + Arguments{"--planes", "300"})));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	std::map<std::string, int> pieces;
	for (const auto& [row, events] : rows.events)
		for (const trace::Event& event : events)
			if (event.category == "worker")
			{
				EXPECT_TRUE(rows.names.at(row).starts_with("worker ")) << rows.names.at(row);
				++pieces[event.name];
				EXPECT_TRUE(std::ranges::any_of(
				    rows.named("main"), [&](const trace::Event& outer)
				    { return outer.name == event.name && outer.begin <= event.begin && event.end <= outer.end; }))
				    << event.name << " " << event.begin;
			}
	EXPECT_GT(pieces["adjacency"], 0);
	// On a busy machine a worker comes to few of these short loops.
	EXPECT_GT(pieces["seed"] + pieces["traverse"] + pieces["emit"], 0);
}

TEST_F(ProfileTrace, GoesToStandardOutput)
{
	const Outcome outcome = run({"profile", "demo:shell:6", "--classify", "cpu", "--planes", "2", "--trace", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_FALSE(trace::check(outcome.out).events.empty());
}

} // namespace cli
