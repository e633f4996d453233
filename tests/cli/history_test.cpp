#include "program.h"

#include <algorithm>
#include <sstream>

namespace cli
{

namespace
{

// vprobe profile --append, --history
class RunHistory : public Program
{
protected:
	Outcome append(const Arguments& options) const
	{
		return run(Arguments{"profile", "demo:shell:6", "--classify", "cpu", "--planes", "2", "--no-floor", "--append",
		                     path("runs.jsonl")} +
		           options);
	}
	// The file with runs like its first one, which take these times.
	std::string likeTheFirst(const std::string& name, const std::vector<double>& times) const
	{
		nlohmann::json run = nlohmann::json::parse(contents(path("runs.jsonl")).substr(0, firstLine()));
		std::string text;
		for (std::size_t k = 0; k < times.size(); ++k)
		{
			run["label"] = "v" + std::to_string(k / 4);
			run["stages"] = nlohmann::json::array({{{"stage", "frame"}, {"median", times[k]}}});
			text += run.dump() + "\n";
		}
		return write(name, text);
	}
	std::size_t firstLine() const { return contents(path("runs.jsonl")).find('\n'); }
	std::string drawn(const std::string& file) const
	{
		EXPECT_TRUE(isQuiet(run({"profile", "--history", file, "-o", path("times.svg")})));
		return contents(path("times.svg"));
	}
};

std::size_t countOf(const std::string& text, const std::string& part)
{
	std::size_t count = 0;
	for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
		++count;
	return count;
}

} // namespace

TEST_F(RunHistory, RunsAreAppended)
{
	ASSERT_TRUE(isQuiet(append({"--label", "v1"})));
	ASSERT_TRUE(isQuiet(append({})));
	std::istringstream file(contents(path("runs.jsonl")));
	std::vector<nlohmann::json> runs;
	for (std::string line; std::getline(file, line);)
		runs.push_back(nlohmann::json::parse(line));
	ASSERT_EQ(runs.size(), 2u);
	EXPECT_EQ(runs[0].at("label"), "v1");
	EXPECT_TRUE(runs[1].at("label").is_null());
	EXPECT_EQ(runs[0].at("work"), runs[1].at("work"));
	EXPECT_EQ(runs[0].at("machine"), runs[1].at("machine"));
	EXPECT_EQ(runs[0].at("time").get<std::string>().size(), 20u);
	EXPECT_EQ(runs[0].at("stages")[0].at("stage"), "frame");
	EXPECT_GT(runs[0].at("stages")[0].at("median"), 0.0);

	// Other work is left out.
	ASSERT_TRUE(isQuiet(append({"--normal", "1", "0", "0"})));
	EXPECT_TRUE(isDoneWithAWord(run({"profile", "--history", path("runs.jsonl"), "-o", path("one.svg")}),
	                            {"2 of 3 runs", "left out"}));
	EXPECT_EQ(countOf(contents(path("one.svg")), ">frame</text>"), 1u);
}

// By hand: 1 ms in eight runs, then 1.5 ms in eight: one step of 50 % behind the eighth. An axis up to 2 ms.
TEST_F(RunHistory, AStepIsMarkedWhereItIs)
{
	ASSERT_TRUE(isQuiet(append({})));
	const std::string svg = drawn(likeTheFirst("step.jsonl", {1.0, 1.01, 0.99, 1.0, 1.02, 1.0, 0.98, 1.0, //
	                                                          1.5, 1.51, 1.49, 1.5, 1.52, 1.5, 1.48, 1.5}));
	EXPECT_EQ(countOf(svg, "class=\"step\""), 1u);
	EXPECT_TRUE(contains(svg, "+50.0 % (p = 0.0")) << svg;
	EXPECT_TRUE(contains(svg, "<line class=\"step\" x1=\"510.0\"")) << svg; // halfway between 90 and 930
	EXPECT_EQ(countOf(svg, "<circle"), 16u);
	EXPECT_EQ(countOf(svg, "class=\"median\""), 4u);
	EXPECT_TRUE(contains(svg, ">2 ms</text>"));
	EXPECT_TRUE(contains(svg, ">v3</text>"));
	EXPECT_TRUE(contains(svg, "Mann-Whitney"));
	EXPECT_EQ(countOf(drawn(likeTheFirst("flat.jsonl", std::vector<double>(16, 1.0))), "class=\"step\""), 0u);
}

TEST_F(RunHistory, WhatCannotBeIsRefused)
{
	ASSERT_TRUE(isQuiet(append({})));
	const auto refused = [&](const Arguments& options, int status, const std::vector<std::string>& words)
	{ EXPECT_TRUE(isError(run(Arguments{"profile"} + options), status, words)) << testing::PrintToString(options); };
	refused({"--history", path("runs.jsonl")}, 1, {"-o FILE.svg"});
	refused({"--history", path("none.jsonl"), "-o", path("a.svg")}, 2, {"none.jsonl", "cannot be read"});
	refused({"--history", write("empty.jsonl", ""), "-o", path("a.svg")}, 2, {"holds no run"});
	refused({"--history", write("odd.jsonl", contents(path("runs.jsonl")) + "{\"time\": 3}\n"), "-o", path("a.svg")}, 2,
	        {"odd.jsonl", "line 2"});
	refused({"demo:shell:4", "--history", path("runs.jsonl"), "-o", path("a.svg")}, 1, {"--history", "leave one"});
	refused({"demo:shell:4", "-o", path("a.svg")}, 1, {"-o", "--history"});
	refused({"demo:shell:4", "--label", "v1"}, 1, {"--label", "--append"});
	refused({"demo:shell:4", "--append", path("runs.jsonl/a.jsonl")}, 4, {"runs.jsonl/a.jsonl"});
	refused({"demo:shell:4", "--append", "-"}, 1, {"--append -"});
	write("grid.vtk", "not read yet");
	refused({path("grid.vtk"), "--append", path("grid.vtk")}, 4, {"grid.vtk"});
	refused({"--history", path("runs.jsonl"), "-o", path("runs.jsonl")}, 4, {"runs.jsonl"});
	refused({"demo:shell:4", "--versus", "--threads 1", "--append", path("runs.jsonl")}, 1, {"--append", "--versus"});
	EXPECT_EQ(files(), (Arguments{"empty.jsonl", "grid.vtk", "odd.jsonl", "runs.jsonl"}));
}

} // namespace cli
