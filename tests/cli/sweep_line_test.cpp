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
	// The first, the middle and the last time are looked at before.
	const Arguments options{overTime(5, 1), "--path", "times", "--range", "0", "3"};
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

// A cube of 2 x 2 x 2 points that grows; at time t its array has the value of `values` everywhere.
TEST_F(SweepLine, CameraAndColorsServeAllTimes)
{
	const std::vector<std::string> values{"1", "8", "2", "3"};
	std::string list = "<?xml version=\"1.0\"?><VTKFile type=\"Collection\" version=\"0.1\"><Collection>";
	for (std::size_t t = 0; t < values.size(); ++t)
	{
		std::string image = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"
		                    "ORIGIN 0 0 0\nSPACING ";
		for (int axis = 0; axis < 3; ++axis)
			image += std::to_string(t + 1) + " ";
		image += "\nPOINT_DATA 8\nSCALARS p float\nLOOKUP_TABLE default\n";
		for (int point = 0; point < 8; ++point)
			image += values[t] + "\n";
		const std::string name = "cube" + std::to_string(t) + ".vtk";
		write(name, image);
		list += "<DataSet timestep=\"" + std::to_string(0.5 * static_cast<double>(t)) + "\" file=\"" + name + "\"/>";
	}
	const std::string file = write("cubes.pvd", list + "</Collection></VTKFile>");
	const Arguments place{file, "--origin", "0.3", "0.3", "0.3"};
	ASSERT_TRUE(isQuiet(sweep("some", place + Arguments{"--path", "times"})));
	ASSERT_TRUE(isQuiet(sweep("all", place + Arguments{"--path", "times", "--range-of", "times"})));
	// The times 0, 2 and 3 are looked at, which have 1 to 3: so 8 lies beyond the ends, and there the legend is
	// pointed.
	for (const int k : {0, 2, 3})
	{
		EXPECT_EQ(frame("some", k) == frame("all", k), k == 0) << k; // the lowest color is that of 1 in both
		const std::string single = path("single.png");
		ASSERT_TRUE(
		    isQuiet(run(Arguments{"render"} + place +
		                Arguments{"--time", "#" + std::to_string(k), "--range-of", "times", "-o", single} + small)));
		EXPECT_TRUE(contents(single) == frame("all", k)) << k; // one picture has the colors and the camera of the film
	}
	// The grids grow: a camera for the first alone would lose the others.
	ASSERT_TRUE(isQuiet(sweep("held", place + Arguments{"--path", "times", "--camera", "z", "--range", "1", "3"})));
	EXPECT_TRUE(frame("held", 0) != frame("held", 3));
	EXPECT_TRUE(frame("held", 1) != frame("some", 1));
}

TEST_F(SweepLine, FiguresAloneHaveTheTimes)
{
	const std::string file = overTime(3, -1);
	ASSERT_TRUE(isQuiet(run({"sweep", file, "--path", "times", "--stats", path("s.json")}, noDevice())));
	const auto frames = json("s.json").at("frames");
	ASSERT_EQ(frames.size(), 3u);
	for (int k = 0; k < 3; ++k)
		EXPECT_EQ(frames[k].at("time"), static_cast<double>(k));
	ASSERT_TRUE(isQuiet(run({"slice", file, "--time", "1", "--stats", path("s.json")}, noDevice())));
	EXPECT_EQ(json("s.json").at("time"), 1.0);
	EXPECT_TRUE(isError(run({"sweep", file, "--path", "times", "--seconds", "3", "-o", path("o.pvd")}, noDevice()), 1,
	                    {"--seconds", "film"}));
	// Frames that are no times have none.
	ASSERT_TRUE(isQuiet(run({"sweep", "demo:shell:6", "--frames", "2", "--stats", path("s.json")}, noDevice())));
	EXPECT_EQ(json("s.json").at("frames")[1].count("time"), 0u);
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

TEST_F(SweepLine, TraceFollowsEachFrameToItsFile)
{
	const Arguments probe{"demo:shell:16", "--frames", "5", "--probe", "trihedral"};
	ASSERT_TRUE(isQuiet(sweep("f", probe + Arguments{"--trace", path("t.json")})));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	ASSERT_EQ(rows.flows.size(), 5u);
	for (const auto& [frame, points] : rows.flows)
	{
		ASSERT_EQ(points.size(), 3u) << frame;
		EXPECT_EQ(points[0].row + ": " + points[0].event, "cutter: cut") << frame;
		EXPECT_EQ(points[1].row + ": " + points[1].event, "main: render") << frame;
		EXPECT_EQ(points[2].row + ": " + points[2].event, "writer: write") << frame;
	}
	for (const std::string at : {"cutter: cut", "main: render", "main: await cut", "writer: write"})
	{
		std::vector<int> frames;
		for (const trace::Event& event : rows.named(at.substr(0, at.find(':'))))
			if (event.name == at.substr(at.find(' ') + 1))
				frames.push_back(event.frame);
		EXPECT_EQ(frames, (std::vector{0, 1, 2, 3, 4})) << at;
	}
	EXPECT_TRUE(rows.about.at("program").starts_with("vprobe ")) << rows.about.at("program");
	EXPECT_TRUE(contains(rows.about.at("command_line"), "sweep -o")) << rows.about.at("command_line");
	EXPECT_TRUE(contains(rows.about.at("command_line"), "--probe trihedral"));
	EXPECT_EQ(rows.about.at("input"), "demo:shell:16");
	const auto told = sweep("f", probe + Arguments{"--stats", path("s.json")});
	ASSERT_TRUE(isQuiet(told));
	EXPECT_EQ(rows.about.at("device"), json("s.json").at("device"));
	EXPECT_EQ(rows.about.at("driver"), json("s.json").at("driver"));
}

TEST_F(SweepLine, TraceShowsTheDeviceAndItsPipelines)
{
	ASSERT_TRUE(
	    isQuiet(sweep("f", {"demo:shell:16", "--frames", "2", "--classify", "gpu", "--trace", path("t.json")})));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	auto device = countsOf(rows.named("device"));
	for (const char* section : {"open device", "Vulkan instance", "Vulkan device", "pipeline compose"})
		EXPECT_EQ(device[section], 1) << section;
	std::map<std::string, int> pipelines; // from all rows
	for (const auto& [row, events] : rows.events)
		for (const trace::Event& event : events)
			if (event.name.starts_with("pipeline "))
			{
				EXPECT_EQ(event.category, "setup");
				++pipelines[event.name];
			}
	for (const char* pipeline : {"pipeline compose", "pipeline layer", "pipeline classify", "pipeline overlay"})
		EXPECT_TRUE(pipelines.contains(pipeline)) << pipeline;
}

TEST_F(SweepLine, TraceCountsWhatWasReadAndIsInMemory)
{
	ASSERT_TRUE(
	    isQuiet(sweep("f", {overTime(3, -1), "--path", "times", "--range", "0", "3", "--trace", path("t.json")})));
	const trace::Rows rows = trace::check(contents(path("t.json")));
	const std::vector<trace::Count>& read = rows.counters.at("bytes read");
	ASSERT_GE(read.size(), 2u);
	EXPECT_TRUE(std::ranges::is_sorted(read, {}, &trace::Count::value));
	EXPECT_TRUE(std::ranges::is_sorted(read, {}, &trace::Count::at));
	EXPECT_GE(read.back().value, 3 * std::filesystem::file_size(path("t0.vti")));
	for (const trace::Count& memory : rows.counters.at("resident memory"))
		EXPECT_TRUE(memory.value > 1'000'000 && memory.value < 100'000'000'000) << memory.value;
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
