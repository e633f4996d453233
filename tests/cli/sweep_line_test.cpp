#include "program.h"
#include "sample_files.h"
#include "trace_check.h"

#include <algorithm>
#include <filesystem>

namespace cli
{

namespace
{

// Several frames of a sweep are under way at once; nobody is to notice.
class SweepLine : public Drawing
{
protected:
	const Arguments small{"--size", "96x64", "--samples", "1", "--background", "white", "--title", ""};

	// Pictures go to NAME/0000.png ...
	Outcome sweep(const std::string& name, const Arguments& options) const
	{
		std::filesystem::create_directory(path(name));
		return run(Arguments{"sweep", "-o", path(name + "/{frame:04}.png")} + small + options);
	}
	std::string frame(const std::string& name, int number) const
	{
		return contents(path(name + "/000" + std::to_string(number) + ".png"));
	}
	nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(contents(path(name))); }
	// A list of images over time; those of `missing` times are not there.
	std::string overTime(int times, int missing) const
	{
		std::string list = "<?xml version=\"1.0\"?><VTKFile type=\"Collection\" version=\"0.1\"><Collection>";
		for (int t = 0; t < times; ++t)
		{
			const std::string name = std::string("t").append(std::to_string(t)).append(".vti");
			if (t != missing)
				write(name, xmlImage());
			list.append("<DataSet timestep=\"")
			    .append(std::to_string(t))
			    .append("\" file=\"")
			    .append(name)
			    .append("\"/>");
		}
		return write("times.pvd", list + "</Collection></VTKFile>");
	}
};

std::map<std::string, int> countsOf(const std::vector<trace::Event>& row)
{
	std::map<std::string, int> counts;
	for (const trace::Event& event : row)
		++counts[event.name];
	return counts;
}

} // namespace

TEST_F(SweepLine, ThreadsChangeNothing)
{
	for (const std::string classifier : {"cpu", "gpu"})
	{
		const Arguments options{"demo:shell:12", "--probe",   "trihedral", "--frames", "7",
		                        "--classify",    classifier,  "--array",   "v",        "--exposure",
		                        path("e.png"),   "--opacity", "0.7",       "--stats",  path("s.json"),
		                        "--path",        "translate"};
		ASSERT_TRUE(isQuiet(sweep("one", options + Arguments{"--threads", "1"})));
		const auto figures = json("s.json").at("frames");
		const std::string exposure = contents(path("e.png"));
		ASSERT_TRUE(isQuiet(sweep("many", options)));
		EXPECT_EQ(json("s.json").at("frames"), figures) << classifier;
		EXPECT_TRUE(contents(path("e.png")) == exposure) << classifier;
		ASSERT_EQ(figures.size(), 7u);
		for (int k = 0; k < 7; ++k)
		{
			EXPECT_EQ(figures[k].at("frame"), k);
			EXPECT_EQ(sizeOf(frame("many", k)), (PictureSize{96, 64}));
			EXPECT_TRUE(frame("many", k) == frame("one", k)) << classifier << " " << k;
		}
	}
}

TEST_F(SweepLine, AFrameThatCannotBeWrittenIsToldAndEndsIt)
{
	for (const Arguments& threads : {Arguments{}, Arguments{"--threads", "1"}})
	{
		std::filesystem::remove_all(path("f"));
		std::filesystem::create_directories(path("f/0002.png"));
		EXPECT_TRUE(isError(sweep("f", Arguments{"demo:shell:12", "--frames", "400"} + threads), 4,
		                    {"0002.png", "give the name of a file in it"}));
		EXPECT_EQ(sizeOf(frame("f", 1)), (PictureSize{96, 64}));
		EXPECT_FALSE(std::filesystem::exists(path("f/0003.png")));
		std::ptrdiff_t left = 0;
		for (const auto& entry : std::filesystem::directory_iterator(path("f")))
			left += entry.path().filename().string().starts_with("000") ? 1 : 100;
		EXPECT_EQ(left, 3); // and nothing unfinished
	}
}

// Reading time 1 fails while frame 0 is still being written.
TEST_F(SweepLine, TheFirstErrorIsTold)
{
	const Arguments options{overTime(3, 1), "--path", "times", "--range", "0", "3"};
	EXPECT_TRUE(isError(sweep("f", options), 2, {"t1.vti"}));
	EXPECT_EQ(sizeOf(frame("f", 0)), (PictureSize{96, 64}));
	std::filesystem::create_directories(path("g/0000.png"));
	EXPECT_TRUE(isError(sweep("g", options), 4, {"0000.png"}));
}

TEST_F(SweepLine, OverTimesTheyFollowEachOther)
{
	ASSERT_TRUE(isQuiet(sweep("f", {overTime(3, -1), "--path", "times", "--range", "0", "3", "--stats", path("s.json"),
	                                "--trace", path("t.json")})));
	EXPECT_EQ(json("s.json").at("frames").size(), 3u);
	for (int k = 0; k < 3; ++k)
		EXPECT_EQ(sizeOf(frame("f", k)), (PictureSize{96, 64}));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	EXPECT_TRUE(rows.named("cutter").empty());
	EXPECT_EQ(countsOf(rows.named("writer"))["write"], 3);
}

TEST_F(SweepLine, ResumesAroundWhatIsThere)
{
	const Arguments options{"demo:shell:12", "--frames", "6"};
	ASSERT_TRUE(isQuiet(sweep("all", options)));
	ASSERT_TRUE(isQuiet(sweep("some", options)));
	for (const int missing : {0, 2, 3, 5})
		std::filesystem::remove(path("some/000" + std::to_string(missing) + ".png"));
	write("some/0004.png", "kept");
	ASSERT_TRUE(isQuiet(sweep("some", options + Arguments{"--resume"})));
	for (int k = 0; k < 6; ++k)
		EXPECT_TRUE(k == 4 ? frame("some", k) == "kept" : frame("some", k) == frame("all", k)) << k;
}

// A probe that rests between two keys is cut once there, and looks as if it were cut each time.
TEST_F(SweepLine, WhatRestsIsNotCutAgain)
{
	const std::string keys = write("keys.json", R"({"path": "keyframes", "keys": [
		{"at": 0, "to_probe": {"origin": [2, 0, 0], "normal": [1, 2, 3]}},
		{"at": 3, "to_probe": {"origin": [2, 0, 0], "normal": [1, 2, 3]}}]})");
	for (const std::string classifier : {"cpu", "gpu"})
	{
		const Arguments options{"demo:shell:12", "--path",   keys,          "--frames",     "4",
		                        "--classify",    classifier, "--stats",     path("s.json"), "--probe",
		                        "paddlewheel",   "--trace",  path("t.json")};
		ASSERT_TRUE(isQuiet(sweep("rest", options)));
		const trace::Rows rows = trace::check(contents(path("t.json")));
		auto counts = countsOf(rows.named("cutter"));
		EXPECT_EQ(counts["cut"], 4);
		EXPECT_EQ(counts["seed"], classifier == "gpu" ? 2 : 1); // hot spots over the sheet apart
		EXPECT_EQ(counts["measure"], 3);
		const auto frames = json("s.json").at("frames");
		ASSERT_EQ(frames.size(), 4u);
		for (int k = 1; k < 4; ++k)
		{
			EXPECT_EQ(frames[k].at("sheets"), frames[0].at("sheets"));
			EXPECT_TRUE(frame("rest", k) == frame("rest", 0)) << classifier << " " << k;
		}
	}
}

TEST_F(SweepLine, TraceShowsEveryFrameOnceInEachRow)
{
	const Arguments options{"demo:shell:16", "--frames", "9", "--probe", "trihedral", "--trace", path("t.json")};
	ASSERT_TRUE(isQuiet(sweep("f", options)));
	trace::Rows rows = trace::check(contents(path("t.json")));
	EXPECT_EQ(countsOf(rows.named("cutter"))["cut"], 9);
	EXPECT_EQ(countsOf(rows.named("writer"))["write"], 9);
	EXPECT_EQ(countsOf(rows.named("main"))["render"], 9);
	EXPECT_EQ(countsOf(rows.named("main"))["await cut"], 9);
	for (const char* row : {"cutter", "main"})
		for (const trace::Event& event : rows.named(row))
			if (event.name == "cut" || event.name == "render")
				trace::expectWhole(rows.named(row), event);

	ASSERT_TRUE(isQuiet(sweep("f", options + Arguments{"--threads", "1"})));
	rows = trace::check(contents(path("t.json")));
	auto alone = countsOf(rows.named("main"));
	for (const char* section : {"cut", "write", "render"})
		EXPECT_EQ(alone[section], 9) << section;
	EXPECT_TRUE(rows.named("cutter").empty());
	EXPECT_TRUE(rows.named("writer").empty());
}

TEST_F(SweepLine, TracesThatCannotBe)
{
	write("none", "a file where the folder would be");
	EXPECT_TRUE(
	    isError(sweep("f", {"demo:shell:4", "--frames", "2", "--trace", path("none/t.json")}), 4, {"none/t.json"}));
	EXPECT_TRUE(isError(sweep("f", {"demo:shell:4", "--frames", "2", "--trace", "-", "--stats", "-"}), 1,
	                    {"--trace -", "--stats -"}));
	EXPECT_TRUE(std::filesystem::is_empty(path("f")));
	const Outcome piped = sweep("f", {"demo:shell:4", "--frames", "2", "--trace", "-"});
	ASSERT_TRUE(isQuiet(piped));
	EXPECT_FALSE(trace::check(piped.out).events.empty());
}

} // namespace cli
