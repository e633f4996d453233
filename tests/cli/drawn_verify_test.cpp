// verify, render --expect and --difference where pictures are compared, and that small faults are found.

#include "png_pixels.h"
#include "program.h"

#include <algorithm>
#include <filesystem>

namespace cli
{

namespace
{

using nlohmann::json;

const Arguments kDrawnShell{"demo:shell:8", "--normal", "0.3", "0.5", "0.8", "--size", "320x240"};

class DrawnVerify : public Drawing
{
protected:
	void save(const std::string& name, const Arguments& options) const
	{
		ASSERT_TRUE(isQuiet(
		    run(Arguments{"render"} + options + Arguments{"--save", path(name + ".json"), "-o", path(name + ".png")})));
	}
	Outcome verify(const Arguments& arguments) const { return run(Arguments{"verify"} + arguments); }
	// Whether the picture with these options is found to differ from the expected one.
	testing::AssertionResult isFound(const Arguments& options, const std::string& expected) const
	{
		const Outcome outcome = run(Arguments{"render"} + options + Arguments{"--expect", path(expected)});
		return outcome.status == 6 && contains(outcome.err, expected + ": is not as drawn: similarity")
		           ? testing::AssertionSuccess()
		           : testing::AssertionFailure() << outcome.status << ' ' << outcome.err;
	}
};

std::size_t timesIn(const std::string& text, const std::string& part)
{
	std::size_t found = 0;
	for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
		++found;
	return found;
}

} // namespace

TEST_F(DrawnVerify, PicturesOfRenderAndSlicePass)
{
	// Two states of one input, which is read once; what is drawn is what render draws, to the last bit.
	save("a", kDrawnShell);
	save("b", {"demo:shell:8", "--probe", "trihedral", "--lines", "6", "--size", "200x160"});
	save("c", {"demo:mixed:4", "--mesh", "--size", "200x160"});
	ASSERT_TRUE(isQuiet(run({"slice", "--state", path("b.json"), "-o", path("b.flat.{sheet}.png")})));
	ASSERT_TRUE(isQuiet(run({"slice", "--state", path("c.json"), "-o", path("c.flat.png")})));
	const Outcome outcome = verify({path(""), "--report", path("report")});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	for (const char* name : {"a.png", "b.png", "b.flat.0.png", "b.flat.2.png", "c.png", "c.flat.png"})
		EXPECT_TRUE(contains(outcome.out, std::string("passed  ") + path(name) + "  equal  [")) << outcome.out;
	EXPECT_TRUE(contains(outcome.out, "7 passed; ")) << outcome.out;
	EXPECT_FALSE(contains(contents(path("report/index.html")), "<img"));
}

TEST_F(DrawnVerify, SweepsAreJudgedByThreeFrames)
{
	const Arguments small{"--size", "160x120"};
	ASSERT_TRUE(isQuiet(run(Arguments{"sweep", "demo:shell:8", "--normal", "0.2", "0.1", "1", "--path", "rotate",
	                                  "--frames", "5", "--save", path("a.json"), "-o", path("{frame}.png")} +
	                        small)));
	const auto take = [&](int frame, const char* name)
	{
		std::filesystem::copy_file(path(std::to_string(frame) + ".png"), path(name),
		                           std::filesystem::copy_options::overwrite_existing);
	};
	take(0, "a.first.png");
	take(2, "a.middle.png");
	take(4, "a.last.png");
	Outcome outcome = verify({path("a.json")});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	for (const char* name : {"a.first.png", "a.middle.png", "a.last.png"})
		EXPECT_TRUE(contains(outcome.out, std::string("passed  ") + path(name) + "  equal  [")) << outcome.out;
	take(3, "a.last.png");
	outcome = verify({path("a.json")});
	EXPECT_EQ(outcome.status, 6);
	EXPECT_TRUE(contains(outcome.out, "differs  " + path("a.last.png"))) << outcome.out;
	for (const char* name : {"a.first.png", "a.middle.png", "a.last.png"})
		std::filesystem::remove(path(name));
	EXPECT_EQ(verify({path("a.json"), "--update"}).status, 0);
	outcome = verify({path("a.json")});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	take(4, "b.png");
	EXPECT_EQ(contents(path("b.png")), contents(path("a.last.png")));
}

TEST_F(DrawnVerify, UpdateWritesWhatIsMissingAndWhatDiffers)
{
	save("a", kDrawnShell);
	ASSERT_TRUE(isQuiet(run(Arguments{"render"} + kDrawnShell + Arguments{"--bands", "5", "-o", path("a.png")})));
	save("b", kDrawnShell);
	std::filesystem::remove(path("b.png"));
	Outcome outcome = verify({path(""), "--report", path("report")});
	EXPECT_EQ(outcome.status, 2);
	EXPECT_TRUE(contains(outcome.out, "differs  " + path("a.png") + "  similarity ")) << outcome.out;
	const std::string page = contents(path("report/index.html"));
	EXPECT_EQ(timesIn(page, "src=\"data:image/png;base64,iVBORw0KGgo"), 5u); // three, and two under the slider
	EXPECT_EQ(timesIn(page, "src="), 5u);
	EXPECT_FALSE(contains(page, "http"));

	outcome = verify({path(""), "--update"});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	for (const char* name : {"a.png", "a.figures.json", "b.png", "b.figures.json"})
		EXPECT_TRUE(contains(outcome.out, std::string("updated  ") + path(name))) << outcome.out;
	outcome = verify({path("")});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	EXPECT_TRUE(contains(outcome.out, "4 passed")) << outcome.out;
}

TEST_F(DrawnVerify, RenderExpect)
{
	save("a", kDrawnShell);
	const Arguments render = Arguments{"render"} + kDrawnShell;
	EXPECT_TRUE(isQuiet(run(render + Arguments{"--expect", path("a.png"), "--difference", path("d.png")})));
	EXPECT_FALSE(std::filesystem::exists(path("d.png")));
	const Outcome other =
	    run(render + Arguments{"--bands", "5", "--expect", path("a.png"), "--difference", path("d.png")});
	EXPECT_TRUE(isError(other, 6, {"a.png: is not as drawn: similarity"}));
	EXPECT_EQ(sizeOf(contents(path("d.png"))), (PictureSize{320, 240}));
	EXPECT_TRUE(
	    isError(run({"render", "demo:shell:8", "--size", "100x80", "--expect", path("a.png")}), 6,
	            {"a.png: is not as drawn: the expected picture has 320 x 240 pixels, and the drawn one 100 x 80"}));
	EXPECT_TRUE(isError(run(render + Arguments{"--difference", path("d.png")}), 1, {"--difference", "--expect"}));
	EXPECT_TRUE(isError(run(render + Arguments{"--expect", path("a.png"), "-o", path("a.png")}), 4, {"a.png"}));
}

// The calibration of docs/CI.md: faults that a program can make.
TEST_F(DrawnVerify, SmallFaultsAreFound)
{
	const Arguments shell = kDrawnShell + Arguments{"--range", "-2.5", "2.5", "--title", "t = 3"};
	save("a", shell);
	EXPECT_TRUE(isQuiet(run(Arguments{"render"} + shell + Arguments{"--expect", path("a.png")})));
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--range", "-2.5", "2.6", "--title", "t = 3"}, "a.png")); // by 2 %
	save("plain", kDrawnShell + Arguments{"--range", "-2.5", "2.5", "--no-legend"});
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--range", "-2.5", "2.6", "--no-legend"}, "plain.png"));
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--range", "-2.6", "2.5", "--no-legend"}, "plain.png"));
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--range", "-2.5", "2.5", "--title", "t = 8"}, "a.png"));
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--range", "-2.5", "2.5", "--title", "t = 2"}, "a.png"));

	// The color at an end of the map, by 4 % of the levels.
	const auto preset = [&](const std::string& name, double last)
	{
		return write(name, json{{{"Name", "own"},
		                         {"ColorSpace", "RGB"},
		                         {"RGBPoints", {0.0, 0.1, 0.2, 0.6, 0.5, 0.6, 0.8, 0.6, 1.0, 0.9, last, 0.2}}}}
		                       .dump());
	};
	save("map", kDrawnShell + Arguments{"--colormap", preset("one.json", 0.90)});
	EXPECT_TRUE(isFound(kDrawnShell + Arguments{"--colormap", preset("two.json", 0.86)}, "map.png"));
}

TEST_F(DrawnVerify, ALostContourLineIsFound)
{
	const Arguments plain = kDrawnShell + Arguments{"--no-labels", "--no-legend"};
	save("lines", plain + Arguments{"--lines", "6"});
	save("none", plain);
	const Pixels lines = readPixels(path("lines.png"));
	const Pixels none = readPixels(path("none.png"));
	int lost = 0;
	for (const std::vector<std::size_t>& line : regionsApart(lines, none))
	{
		if (line.size() < 40) // a stub at a rim
			continue;
		Pixels without = lines;
		for (const std::size_t pixel : line)
			std::copy_n(&none.rgba[4 * pixel], 4, &without.rgba[4 * pixel]);
		writePixels(without, path("lost.png"));
		EXPECT_TRUE(isFound(plain + Arguments{"--lines", "6"}, "lost.png")) << line.size();
		++lost;
	}
	EXPECT_GE(lost, 3);
}

} // namespace cli
