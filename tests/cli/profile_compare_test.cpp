#include "program.h"

#include <algorithm>
#include <sstream>

namespace cli
{

namespace
{

// vprobe profile --compare
class Compare : public Program
{
protected:
	// A profile as far as --compare looks at it.
	std::string profileFile(const std::string& name, const nlohmann::json& changes) const
	{
		nlohmann::json json = {
		    {"input", "demo:shell:8"},
		    {"planes", 60},
		    {"cut_ms", {{"first", 9.0}, {"median", 2.0}, {"p95", 3.0}, {"noise", 0.1}}},
		    {"frame_ms", nullptr},
		    {"cut_cells_mean", 1000.0},
		    {"memory_bytes", {{"grid", 5000}, {"extra", 700}}},
		    {"stages", nlohmann::json::array({{{"stage", "seed"}, {"median", 0.5}, {"p95", 0.6}, {"noise", 0.01}}})}};
		if (changes.is_object())
			json.merge_patch(changes);
		return write(name, json.dump());
	}
	Outcome compare(const std::string& a, const std::string& b) const { return run({"profile", "--compare", a, b}); }
};

std::vector<std::string> lines(const std::string& text)
{
	std::vector<std::string> all;
	std::istringstream stream(text);
	for (std::string line; std::getline(stream, line);)
		all.push_back(line);
	return all;
}

std::string lineWith(const std::string& text, const std::string& word)
{
	for (const std::string& line : lines(text))
		if (line.starts_with(word))
			return line;
	return {};
}

} // namespace

TEST_F(Compare, ComparedWithItselfNothingChanged)
{
	const std::string a = profileFile("a.json", {});
	const Outcome outcome = compare(a, a);
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_TRUE(contains(outcome.out, "8 figures are the same")) << outcome.out;
	EXPECT_FALSE(contains(outcome.out, "not of the same work"));
	EXPECT_TRUE(lineWith(outcome.out, "cut_ms").empty());
}

TEST_F(Compare, ComparisonSortsAndTellsChance)
{
	const nlohmann::json changes = {{"cut_ms", {{"median", 3.9}, {"p95", 9.5}}},
	                                {"cut_cells_mean", 1001.0},
	                                {"frame_ms", {{"first", 50.0}, {"median", 40.0}, {"p95", 41.0}, {"noise", 1.0}}},
	                                {"memory_bytes", {{"extra", 7000}}}};
	// By hand: the medians differ 1.95 times (up to 2 may be chance), the percentiles 3.17 times (up to 3).
	const Outcome outcome = compare(profileFile("a.json", {}), profileFile("b.json", changes));
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_TRUE(contains(lineWith(outcome.out, "cut_ms.median"), "may be chance")) << outcome.out;
	EXPECT_TRUE(contains(lineWith(outcome.out, "cut_ms.p95"), "3.167")) << outcome.out;
	EXPECT_FALSE(contains(lineWith(outcome.out, "cut_ms.p95"), "may be chance"));
	// Cells are counted: one more is one more.
	EXPECT_TRUE(contains(lineWith(outcome.out, "cut_cells_mean"), "1.001"));
	EXPECT_FALSE(contains(lineWith(outcome.out, "cut_cells_mean"), "may be chance"));
	EXPECT_TRUE(contains(outcome.out, "not measured in turns")) << outcome.out;
	std::vector<std::size_t> order;
	for (const char* key : {"frame_ms.first", "memory_bytes.extra", "cut_ms.p95", "cut_cells_mean", "cut_ms.median"})
		order.push_back(outcome.out.find(key));
	EXPECT_TRUE(std::ranges::is_sorted(order)) << outcome.out;
	EXPECT_LT(order.back(), outcome.out.size());
	EXPECT_TRUE(lineWith(outcome.out, "stages.seed").empty());
}

// Times of two runs that spread by 24 %, as runs of one program do, and stages of some microseconds.
TEST_F(Compare, WhatARepeatWouldNotShowMayBeChance)
{
	const nlohmann::json changes = {
	    {"cut_ms", {{"first", 11.2}, {"median", 2.48}, {"p95", 3.72}}},
	    {"stages", nlohmann::json::array({{{"stage", "seed"}, {"median", 0.62}, {"p95", 0.75}, {"noise", 0.001}},
	                                      {{"stage", "measure"}, {"median", 0.04}, {"p95", 0.05}, {"noise", 0.0}}})}};
	const nlohmann::json before = {
	    {"stages", nlohmann::json::array({{{"stage", "seed"}, {"median", 0.5}, {"p95", 0.6}, {"noise", 0.01}},
	                                      {{"stage", "measure"}, {"median", 0.001}, {"p95", 0.002}, {"noise", 0.0}}})}};
	const Outcome outcome = compare(profileFile("a.json", before), profileFile("b.json", changes));
	ASSERT_TRUE(isQuiet(outcome));
	int told = 0;
	for (const std::string& line : lines(outcome.out))
		if (line.starts_with("cut_ms.") || line.starts_with("stages."))
		{
			++told;
			EXPECT_TRUE(contains(line, "may be chance")) << line;
		}
	EXPECT_EQ(told, 7) << outcome.out;
}

TEST_F(Compare, ComparisonTellsOtherWork)
{
	const Outcome outcome = compare(profileFile("a.json", {{"threads", 2}}),
	                                profileFile("b.json", {{"threads", 1}, {"input", "demo:shell:9"}}));
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_TRUE(contains(outcome.out, "not of the same work")) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "input: demo:shell:8 | demo:shell:9")) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "threads: 2 | 1")) << outcome.out;
}

TEST_F(Compare, RealProfilesCompare)
{
	for (const std::string name : {"a.json", "b.json"})
		ASSERT_TRUE(isQuiet(run({"profile", "demo:hexes:8", "--classify", "cpu", "--json", path(name)})));
	const Outcome outcome = compare(path("a.json"), path("b.json"));
	ASSERT_TRUE(isQuiet(outcome));
	EXPECT_FALSE(contains(outcome.out, "not of the same work")) << outcome.out;
	EXPECT_FALSE(lineWith(outcome.out, "cut_ms.median").empty()) << outcome.out;
	EXPECT_TRUE(lineWith(outcome.out, "cut_cells_mean").empty()) << outcome.out;
}

TEST_F(Compare, ProfilesThatCannotBeCompared)
{
	const std::string good = profileFile("a.json", {});
	const auto refused = [&](const std::string& b, const std::vector<std::string>& words)
	{
		EXPECT_TRUE(isError(compare(good, b), 2, words)) << b;
		EXPECT_TRUE(isError(compare(b, good), 2, words)) << b;
	};
	refused(path("none.json"), {"none.json", "cannot be read", "--json"});
	refused(path(""), {"cannot be read"});
	refused(write("b.json", "{\"cut_ms\""), {"b.json", "is no JSON object"});
	refused(write("c.json", "[1, 2]"), {"c.json", "is no JSON object"});
	std::string deep;
	for (int i = 0; i < 100'000; ++i)
		deep += "{\"a\":";
	refused(write("f.json", deep + "1" + std::string(100'000, '}')), {"f.json", "cut_ms"});
	refused(write("d.json", R"({"sheets": []})"), {"d.json", "cut_ms"});
	refused(write("e.json", R"({"cut_ms": 3})"), {"e.json", "cut_ms"});
}

} // namespace cli
