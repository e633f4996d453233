#include "program.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace cli
{

namespace
{

class Sweep : public Drawing
{
protected:
	const Arguments small{"--size", "96x64", "--samples", "1", "--background", "white", "--title", ""};
	const std::string pattern = path("{frame:04}.png");

	Outcome sweep(const Arguments& options) const { return run(Arguments{"sweep", "demo:shell:12"} + small + options); }
	std::string frame(int number) const
	{
		const std::string digits = std::to_string(number);
		return contents(path(std::string(4 - digits.size(), '0') + digits + ".png"));
	}
};

class Film : public Sweep
{
protected:
	void SetUp() override
	{
		if (!answers("ffmpeg -version"))
			GTEST_SKIP() << "ffmpeg is not installed";
		Sweep::SetUp();
	}
	static bool answers(const std::string& command) { return std::system((command + " >/dev/null 2>&1").c_str()) == 0; }
	// Returns the number of frames that ffprobe decodes. Returns nothing if ffprobe is not installed.
	static std::optional<int> framesIn(const std::string& film)
	{
		if (!answers("ffprobe -version"))
			return std::nullopt;
		FILE* pipe = popen(("ffprobe -v error -count_frames -select_streams v -of csv=p=0 -show_entries "
		                    "stream=nb_read_frames '" +
		                    film + "'")
		                       .c_str(),
		                   "r");
		std::array<char, 64> text{};
		const bool read = pipe && std::fgets(text.data(), text.size(), pipe);
		if (pipe)
			pclose(pipe);
		return read ? std::atoi(text.data()) : -1;
	}
};

class BadSweep : public Program, public testing::WithParamInterface<std::pair<Arguments, std::string>>
{
};

} // namespace

TEST_F(Sweep, ContextStaysWhereItIs)
{
	const Arguments path{"--path", "translate", "--frames", "2", "-o", pattern};
	ASSERT_TRUE(isQuiet(sweep(path)));
	const std::string plain = frame(0);
	ASSERT_TRUE(isQuiet(sweep(path + Arguments{"--context", "boundary"})));
	EXPECT_NE(frame(0), plain);
	EXPECT_NE(frame(0), frame(1));
}

TEST_F(Sweep, FramesAreNumberedAndWhole)
{
	ASSERT_TRUE(isQuiet(sweep({"--frames", "3", "-o", pattern})));
	EXPECT_EQ(files(), (Arguments{"0000.png", "0001.png", "0002.png"}));
	for (int k = 0; k < 3; ++k)
		EXPECT_EQ(sizeOf(frame(k)), (PictureSize{96, 64})) << k;
	EXPECT_TRUE(frame(0) != frame(1));
	EXPECT_TRUE(frame(1) != frame(2));
}

TEST_F(Sweep, EachPath)
{
	for (const std::string name : {"translate", "rotate", "spin", "revolve", "profile"})
	{
		const Arguments probe = name == "revolve" ? Arguments{"--probe", "paddlewheel"}
		                                          : Arguments{"--up", "1", "1", "0", "--window", "2", "1"};
		ASSERT_TRUE(isQuiet(
		    sweep(Arguments{"--path", name, "--frames", "3", "--stats", path("s.json"), "-o", pattern} + probe)))
		    << name;
		const auto told = nlohmann::json::parse(contents(path("s.json")));
		EXPECT_EQ(told.at("frames").size(), 3u) << name;
		EXPECT_TRUE(frame(0) != frame(1)) << name;
	}
}

// Frame k of a paddlewheel that revolves is what the probe, turned as far by hand, looks like; and the frame after the
// last is the first again.
TEST_F(Sweep, RevolvingPaddlewheelLoops)
{
	const Arguments wheel{"--probe", "paddlewheel", "--origin",  "0.2", "0.3",     "0.1", "--camera",  "iso",
	                      "--size",  "96x64",       "--samples", "1",   "--title", "",    "--outline", "none"};
	ASSERT_TRUE(isQuiet(run(Arguments{"sweep", "demo:shell:12", "--path", "revolve", "--frames", "4", "-o", pattern,
	                                  "--stats", path("s.json")} +
	                        wheel)));
	const auto told = nlohmann::json::parse(contents(path("s.json"))).at("frames");
	ASSERT_EQ(told.size(), 4u);
	const auto normal = [&](int k, int vane) { return told[k].at("sheets")[vane].at("normal"); };
	// Vane 0 goes by 30 degrees a frame about y and stands, at frame 4, where vane 1 stood at frame 0: at 120.
	const auto angle = [](const nlohmann::json& n) { return std::atan2(n[0].get<double>(), n[2].get<double>()); };
	const double step = std::remainder(angle(normal(1, 0)) - angle(normal(0, 0)), M_PI);
	const double vanes = std::remainder(angle(normal(0, 1)) - angle(normal(0, 0)), M_PI);
	EXPECT_NEAR(std::abs(step), M_PI / 6.0, 1e-9);
	EXPECT_NEAR(std::remainder(4.0 * step - vanes, M_PI), 0.0, 1e-9);
	EXPECT_TRUE(frame(0) != frame(2));

	// The pose after the last, drawn: the probe turned by 120 degrees about y.
	std::filesystem::create_directory(path("next"));
	const Arguments turned = Arguments{"--normal", "0.8660254037844387", "0", "-0.5"};
	ASSERT_TRUE(isQuiet(run(Arguments{"sweep", "demo:shell:12", "--path", "revolve", "--frames", "1", "-o",
	                                  path("next/{frame:04}.png"), "--stats", path("t.json")} +
	                        wheel + turned)));
	const auto next = nlohmann::json::parse(contents(path("t.json"))).at("frames")[0].at("sheets");
	std::vector<double> areas, areas_next;
	for (int vane = 0; vane < 3; ++vane)
	{
		areas.push_back(told[0].at("sheets")[vane].at("area"));
		areas_next.push_back(next[vane].at("area"));
	}
	std::ranges::sort(areas);
	std::ranges::sort(areas_next);
	for (int vane = 0; vane < 3; ++vane)
		EXPECT_NEAR(areas[vane], areas_next[vane], 1e-9) << vane;
}

TEST_F(Sweep, ThereAndBack)
{
	ASSERT_TRUE(isQuiet(sweep({"--frames", "6", "--there-and-back", "-o", pattern})));
	EXPECT_EQ(files().size(), 6u);
	EXPECT_TRUE(frame(1) == frame(5));
	EXPECT_TRUE(frame(2) == frame(4));
	EXPECT_TRUE(frame(0) != frame(3));
}

TEST_F(Sweep, PathOfAFileSaysHowManyFrames)
{
	const std::string keys = write("keys.json", R"({"path": "keyframes", "unit": "seconds", "keys": [
		{"at": 0, "to_probe": {"origin": [1, 0, 0], "normal": [1, 0, 0]}},
		{"at": 1, "to_probe": {"origin": [1, 1, 0], "normal": [0, 1, 0]}}]})");
	ASSERT_TRUE(isQuiet(sweep({"--path", keys, "--fps", "4", "-o", pattern})));
	const auto pictures = std::ranges::count_if(files(), [](const std::string& f) { return f.ends_with(".png"); });
	EXPECT_GE(pictures, 4);
	EXPECT_LE(pictures, 5);
	EXPECT_TRUE(frame(0) != frame(3));
}

TEST_F(Sweep, ResumeLeavesWhatIsThere)
{
	ASSERT_TRUE(isQuiet(sweep({"--frames", "3", "-o", pattern})));
	const std::string first = frame(0);
	write("0001.png", "kept");
	std::filesystem::remove(path("0000.png"));
	ASSERT_TRUE(isQuiet(sweep({"--frames", "3", "-o", pattern, "--resume"})));
	EXPECT_TRUE(frame(0) == first);
	EXPECT_EQ(frame(1), "kept");
	ASSERT_TRUE(isQuiet(sweep({"--frames", "3", "-o", pattern})));
	EXPECT_NE(frame(1), "kept");
}

TEST_F(Sweep, ExposureHoldsEveryFrame)
{
	ASSERT_TRUE(isQuiet(sweep({"--frames", "4", "--exposure", path("e.png")})));
	EXPECT_EQ(files(), Arguments{"e.png"});
	const std::string exposure = contents(path("e.png"));
	EXPECT_EQ(sizeOf(exposure), (PictureSize{96, 64}));

	// One frame's exposure is that frame without its caption; more frames are more than any of them.
	ASSERT_TRUE(isQuiet(sweep({"--frames", "1", "--exposure", path("one.png"), "-o", pattern})));
	EXPECT_TRUE(contents(path("one.png")) == frame(0));
	ASSERT_TRUE(isQuiet(sweep({"--frames", "4", "--exposure", path("e2.png"), "-o", pattern})));
	EXPECT_TRUE(contents(path("e2.png")) == exposure);
	for (int k = 0; k < 4; ++k)
		EXPECT_TRUE(frame(k) != exposure) << k;
}

// No frame is taken for the background, nor the rim of its window.
TEST_F(Sweep, ExposureIsTheSameInAnyOrder)
{
	std::vector<std::string> exposures;
	for (const char* keys :
	     {R"("at": 0, "to_probe": {"origin": [1, 0, 0]}}, {"at": 1, "to_probe": {"origin": [2, 1, 0]}})",
	      R"("at": 0, "to_probe": {"origin": [2, 1, 0]}}, {"at": 1, "to_probe": {"origin": [1, 0, 0]}})"})
	{
		const std::string file = write("keys.json", std::string(R"({"path": "keyframes", "keys": [{)") + keys + "]}");
		ASSERT_TRUE(isQuiet(sweep({"--path", file, "--frames", "2", "--window", "1", "0.5", "--camera", "0", "-9", "4",
		                           "0", "1", "0", "0", "0", "1", "--exposure", path("e.png")})));
		exposures.push_back(contents(path("e.png")));
	}
	EXPECT_TRUE(exposures[0] == exposures[1]);
}

TEST_F(Sweep, InterruptedItLeavesWholeFramesAndGoesOn)
{
	const Arguments options = Arguments{"sweep", "demo:shell:12", "--frames", "9000", "-o", pattern} + small;
	const Outcome outcome = interrupted(options, [&] { return files().size() >= 3; });
	EXPECT_EQ(outcome.status, 130) << outcome.err;
	const Arguments left = files();
	ASSERT_GE(left.size(), 2u);
	EXPECT_LT(left.size(), 9000u);
	for (std::size_t k = 0; k < left.size(); ++k)
		EXPECT_EQ(sizeOf(contents(path(left[k]))), (PictureSize{96, 64})) << left[k];

	const auto written = std::filesystem::last_write_time(path("0000.png"));
	ASSERT_TRUE(isQuiet(sweep({"--frames", std::to_string(left.size() + 2), "-o", pattern, "--resume"})));
	EXPECT_EQ(files().size(), left.size() + 2);
	EXPECT_EQ(std::filesystem::last_write_time(path("0000.png")), written);
}

TEST_F(Film, HoldsEveryFrame)
{
	for (const std::string name : {"a.mp4", "a.gif"})
	{
		ASSERT_TRUE(isQuiet(sweep({"--frames", "7", "-o", path(name)}))) << name;
		EXPECT_EQ(framesIn(path(name)).value_or(7), 7) << name;
		EXPECT_GT(contents(path(name)).size(), 100u);
	}
	EXPECT_EQ(files(), (Arguments{"a.gif", "a.mp4"}));
}

TEST_F(Film, OddSidesAreFilmedToo)
{
	ASSERT_TRUE(isQuiet(
	    run({"sweep", "demo:shell:12", "--samples", "1", "--frames", "2", "--size", "97x65", "-o", path("a.mp4")})));
	EXPECT_EQ(framesIn(path("a.mp4")).value_or(2), 2);
}

TEST_F(Film, InterruptedItLeavesNothing)
{
	const Arguments options = Arguments{"sweep", "demo:shell:12", "--frames", "100000", "-o", path("a.mp4")} + small;
	const Outcome outcome = interrupted(options, [&] { return !files().empty(); });
	EXPECT_EQ(outcome.status, 130) << outcome.err;
	usleep(200'000); // for ffmpeg to end, which must not bring the file back
	EXPECT_TRUE(files().empty()) << files().front();
}

TEST_F(Sweep, FilmsWithoutFfmpegAreRefused)
{
	const Outcome outcome = run(Arguments{"sweep", "demo:shell:12", "--frames", "2", "-o", path("a.mp4")} + small,
	                            {.environment = {{"PATH", "/nonexistent"}}});
	EXPECT_TRUE(isError(outcome, 4, {"a.mp4", "ffmpeg", "not installed", "{frame:04}.png"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Sweep, PlacesThatCannotBeAreToldAtOnce)
{
	write("none", "a file where the folder would be");
	EXPECT_TRUE(isError(sweep({"--frames", "2", "-o", path("none/{frame}.png")}), 4, {"none", "no folder"}));
	EXPECT_TRUE(isError(sweep({"--frames", "2", "-o", pattern, "--exposure", path("none/e.png")}), 4, {"none/e.png"}));
	EXPECT_TRUE(isError(sweep({"--frames", "2", "-o", pattern, "--stats", path("none/s.json")}), 4, {"none/s.json"}));
	EXPECT_TRUE(isError(sweep({"--frames", "2", "-o", pattern, "--save", path("none/s.json")}), 4, {"none/s.json"}));
	EXPECT_EQ(files(), Arguments{"none"});
}

TEST_F(Sweep, FramesThatMissTheGridAreTold)
{
	EXPECT_TRUE(isDoneWithAWord(
	    sweep({"--frames", "3", "--origin", "50", "0", "0", "--path", "spin", "--normal", "x", "-o", pattern}),
	    {"3 of 3 frames are empty"}));
	EXPECT_EQ(files().size(), 3u);
}

TEST_P(BadSweep, IsOneLineAndNothingIsWritten)
{
	const auto& [arguments, word] = GetParam();
	Arguments placed;
	for (const std::string& argument : arguments)
		placed.push_back(argument.starts_with("@") ? path(argument.substr(1)) : argument);
	EXPECT_TRUE(isError(run(Arguments{"sweep", "demo:shell:4"} + placed), 1, {word}));
	EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Sweeps, BadSweep,
    testing::Values(std::pair(Arguments{"--frames", "2"}, "-o"), std::pair(Arguments{"-o", "@{frame}.png"}, "--frames"),
                    std::pair(Arguments{"--frames", "0", "-o", "@{frame}.png"}, "--frames"),
                    std::pair(Arguments{"--frames", "1000001", "-o", "@{frame}.png"}, "--frames"),
                    std::pair(Arguments{"--frames", "2", "-o", "@a.png"}, "{frame:04}"),
                    std::pair(Arguments{"--frames", "2", "-o", "@{frame}.jpg"}, "-o"),
                    std::pair(Arguments{"--frames", "2", "-o", "-"}, "-o"),
                    std::pair(Arguments{"--frames", "2", "--fps", "0", "-o", "@{frame}.png"}, "--fps"),
                    std::pair(Arguments{"--frames", "2", "--fps", "nan", "-o", "@{frame}.png"}, "--fps"),
                    std::pair(Arguments{"--frames", "2", "--path", "loop", "-o", "@{frame}.png"}, "--path loop"),
                    std::pair(Arguments{"--frames", "2", "--path", "keyframes", "-o", "@{frame}.png"}, "FILE.json"),
                    std::pair(Arguments{"--frames", "2", "--exposure", "@e.jpg"}, "--exposure"),
                    std::pair(Arguments{"--frames", "2", "--resume", "-o", "@a.mp4"}, "--resume"),
                    std::pair(Arguments{"--frames", "2", "--resume", "-o", "@a.pvd"}, "--resume"),
                    std::pair(Arguments{"--frames", "2", "--opacity", "1.5", "-o", "@{frame}.png"}, "--opacity"),
                    std::pair(Arguments{"--frames", "2", "--window", "0", "1", "-o", "@{frame}.png"}, "--window")));

TEST_F(Sweep, PathFilesThatDoNotFit)
{
	const auto refused = [&](const std::string& text, const std::vector<std::string>& words)
	{
		const std::string file = write("path.json", text);
		EXPECT_TRUE(isError(sweep({"--path", file, "--frames", "2", "-o", pattern}), 2, words)) << text;
		EXPECT_EQ(files(), Arguments{"path.json"});
	};
	refused("{\n\"path\" \"spin\"}", {"path.json", "line 2, column"});
	refused(R"({"path": "spin", "speed": 2})", {"/speed", "unknown key"});
	refused(R"({"path": "rotate", "axis": [0, 0, 0]})", {"/axis"});
	refused(R"({"path": "spin", "length": 0})", {"/length"});
}

} // namespace cli
