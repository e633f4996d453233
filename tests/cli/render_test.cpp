#include "program.h"
#include "similar_pictures.h"

namespace cli
{

namespace
{

class Render : public Drawing
{
protected:
	Outcome render(const Arguments& options, const Surroundings& surroundings = {}) const
	{
		return run(Arguments{"render", "demo:shell:16", "--normal", "0.3", "0.5", "0.81"} + options, surroundings);
	}
};

} // namespace

TEST_F(Render, Picture)
{
	ASSERT_TRUE(isQuiet(render({"-o", path("out.png"), "--size", "200x120"})));
	EXPECT_EQ(files(), Arguments{"out.png"});
	EXPECT_EQ(sizeOf(contents(path("out.png"))), (PictureSize{200, 120}));
}

TEST_F(Render, WithoutANameThePictureHasTheInputs)
{
	Surroundings here;
	here.folder = path("");
	const Outcome drawn = render({"--size", "64x64"}, here);
	EXPECT_EQ(drawn.status, 0) << drawn.err;
	EXPECT_EQ(drawn.out, "demo-shell-16.png\n");
	EXPECT_EQ(sizeOf(contents(path("demo-shell-16.png"))), (PictureSize{64, 64}));
	// An existing file stays.
	EXPECT_TRUE(isError(render({"--size", "32x32"}, here), 1, {"demo-shell-16.png", "-o"}));
	EXPECT_EQ(sizeOf(contents(path("demo-shell-16.png"))), (PictureSize{64, 64}));
	EXPECT_EQ(files(), Arguments{"demo-shell-16.png"});
}

TEST_F(Render, TimesAddUp)
{
	const Outcome outcome = render({"-o", path("out.png"), "--size", "200x120", "--stats", "-"});
	ASSERT_TRUE(isQuiet(outcome));
	const nlohmann::json ms = outcome.json()["ms"];
	EXPECT_GT(ms["render"].get<double>(), 0.0);
	EXPECT_LT(ms["render"].get<double>() + ms["build"].get<double>(), ms["total"].get<double>());
}

TEST_F(Render, IsTheSameTwice)
{
	ASSERT_TRUE(isQuiet(render({"-o", path("a.png"), "--size", "200x120"})));
	ASSERT_TRUE(isQuiet(render({"-o", path("b.png"), "--size", "200x120"})));
	EXPECT_EQ(contents(path("a.png")), contents(path("b.png")));
}

TEST_F(Render, PictureInParts)
{
	const Arguments size{"--size", "640x480", "--samples", "8"};
	ASSERT_TRUE(isQuiet(render(Arguments{"-o", path("whole.png")} + size)));
	const Outcome parts = render(Arguments{"-o", path("parts.png"), "--device-memory", "8M"} + size);
	EXPECT_EQ(parts.status, 0);
	EXPECT_TRUE(contains(parts.err, "parts")) << parts.err;
	EXPECT_TRUE(contains(parts.err, "--device-memory")) << parts.err;
	EXPECT_TRUE(areSimilar(path("whole.png"), path("parts.png")));
	EXPECT_TRUE(isError(render(Arguments{"-o", path("none.png"), "--device-memory", "1M"} + size), 4,
	                    {"--size", "--device-memory"}));
	EXPECT_EQ(files(), (Arguments{"parts.png", "whole.png"}));
}

TEST_F(Render, Cameras)
{
	for (const Arguments& camera : {Arguments{"x"}, Arguments{"-x"}, Arguments{"y"}, Arguments{"-y"}, Arguments{"z"},
	                                Arguments{"-z"}, Arguments{"iso"}, Arguments{"sheet"}, Arguments{"30,-20"},
	                                Arguments{"9", "9", "9", "0", "0", "0", "0", "0", "1"}})
	{
		EXPECT_TRUE(isQuiet(render(Arguments{"-o", path("out.png"), "--size", "64x64", "--camera"} + camera)))
		    << camera.front();
		EXPECT_EQ(sizeOf(contents(path("out.png"))), (PictureSize{64, 64}));
	}
}

TEST_F(Render, OptionsChangeThePicture)
{
	const auto picture = [&](const Arguments& options)
	{
		const std::string name = path("out.png");
		EXPECT_TRUE(isQuiet(render(Arguments{"-o", name, "--size", "200x120"} + options))) << options.front();
		return contents(name);
	};
	const std::string plain = picture({"--background", "white"});
	for (const Arguments& options :
	     {Arguments{"--background", "black"}, Arguments{"--background", "white", "--range", "-0.1", "0.1"},
	      Arguments{"--background", "white", "--range-of", "slice"}, Arguments{"--background", "white", "--no-legend"},
	      Arguments{"--background", "white", "--camera", "x"}, Arguments{"--background", "white", "--array", "v"},
	      Arguments{"--background", "white", "--origin", "0", "1", "0"},
	      Arguments{"--background", "white", "--colormap", "viridis_r"}, Arguments{"--background", "white", "--mesh"},
	      Arguments{"--background", "white", "--lines", "8"}, Arguments{"--background", "white", "--bands", "8"},
	      Arguments{"--background", "white", "--opacity", "0.4"}, Arguments{"--background", "white", "--axes", "box"},
	      Arguments{"--background", "white", "--axes", "none"}, Arguments{"--background", "white", "--lit"},
	      Arguments{"--background", "white", "--context", "boundary"},
	      Arguments{"--background", "white", "--outline", "none"}, Arguments{"--background", "white", "--title", ""}})
		EXPECT_NE(picture(options), plain) << options[options.size() - 2];
}

TEST_F(Render, RangesOfSlices)
{
	const Arguments where{"--origin", "1", "1.2", "0.1", "--normal", "x"};
	ASSERT_TRUE(
	    isQuiet(run(Arguments{"slice", "demo:shell:16", "-o", path("a.vtp"), "--stats", path("s.json")} + where)));
	const nlohmann::json sheet = nlohmann::json::parse(contents(path("s.json"))).at("sheets").at(0);
	const auto number = [](double value) { return nlohmann::json(value).dump(); };
	const double lo = sheet.at("min");
	const double hi = sheet.at("max");
	const double most = std::max(std::abs(lo), std::abs(hi));
	const auto picture = [&](const Arguments& options)
	{
		EXPECT_TRUE(isQuiet(
		    run(Arguments{"render", "demo:shell:16", "-o", path("out.png"), "--size", "200x120", "--no-legend"} +
		        where + options)));
		return contents(path("out.png"));
	};
	const std::string of_slice = picture({"--range-of", "slice"});
	EXPECT_TRUE(of_slice == picture({"--range", number(lo), number(hi)}));
	EXPECT_TRUE(of_slice != picture({}));
	EXPECT_TRUE(picture({"--range-of", "slice", "--symmetric"}) == picture({"--range", number(-most), number(most)}));
	EXPECT_TRUE(picture({"--symmetric", "--range", "-0.2", "0.4"}) == picture({"--range", "-0.2", "0.4"}));
}

TEST_F(Render, AFixedRangeDoesNotHangOnWhatIsShown)
{
	write("v.raw", std::string(32 * 32 * 32 * sizeof(float), '\0'));
	const Arguments stays{"render",   path("v.raw"), "--raw-size", "32x32x32", "--raw-type", "float32",
	                      "--memory", "64K",         "--size",     "64x64",    "-o",         path("out.png")};
	EXPECT_TRUE(isDoneWithAWord(run(stays), {"--range", "values that are shown"}));
	EXPECT_TRUE(isQuiet(run(stays + Arguments{"--range", "0", "1"})));
}

TEST_F(Render, ContextIsTranslucentAsAsked)
{
	const auto picture = [&](const Arguments& options)
	{
		EXPECT_TRUE(isQuiet(render(Arguments{"-o", path("out.png"), "--size", "200x120"} + options)));
		return contents(path("out.png"));
	};
	const std::string faint = picture({"--context", "boundary"});
	EXPECT_EQ(picture({"--context", "boundary"}), faint);
	EXPECT_EQ(picture({"--context", "boundary:0.15"}), faint);
	EXPECT_NE(picture({"--context", "boundary:0.5"}), faint);
	EXPECT_NE(picture({"--context", "boundary", "--context", "boundary"}), faint);
	ASSERT_TRUE(isQuiet(render({"-o", path("none.png"), "--size", "200x120"})));
	picture({"--context", "boundary:0"});
	EXPECT_TRUE(areSimilar(path("out.png"), path("none.png")));
}

TEST_F(Render, ColorMapsFromFiles)
{
	const std::string file = write("map.json", R"([{"Name":"a","RGBPoints":[0,1,0,0, 1,0,0,1]},
	                                               {"Name":"b","IndexedColors":[1,0,0, 0,1,0]}])");
	const Arguments out{"-o", path("out.png"), "--size", "64x64", "--colormap"};
	EXPECT_TRUE(isQuiet(render(out + Arguments{file + ":a"})));
	const std::string forward = contents(path("out.png"));
	EXPECT_TRUE(isQuiet(render(out + Arguments{file + ":a_r"})));
	EXPECT_NE(contents(path("out.png")), forward);
	EXPECT_TRUE(isQuiet(render(out + Arguments{file + ":b"})));
	std::filesystem::remove(path("out.png"));

	EXPECT_TRUE(isError(render(out + Arguments{file}), 2, {file, "a, b"}));
	EXPECT_TRUE(isError(render(out + Arguments{file + ":c"}), 2, {file, "'c'"}));
	EXPECT_TRUE(isError(render(out + Arguments{path("absent.json")}), 2, {"--colormap", "absent.json"}));
	EXPECT_TRUE(isError(render(out + Arguments{write("bad.json", "{]")}), 2, {"bad.json", "JSON"}));
	std::filesystem::create_directory(path("folder.json"));
	EXPECT_TRUE(isError(render(out + Arguments{path("folder.json")}), 2, {"folder.json"}));
	for (const Arguments& option :
	     {Arguments{"--log"}, Arguments{"--lines", "3"}, Arguments{"--bands", "3"}, Arguments{"--range", "0", "1"}})
		EXPECT_TRUE(isError(render(out + Arguments{file + ":b"} + option), 1, {option[0], "categories"}));
	EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

TEST_F(Render, SheetsWithLooksOfTheirOwn)
{
	const Arguments out{"-o", path("out.png"), "--size", "200x120", "--background", "white", "--probe"};
	const auto picture = [&](const std::string& wishes)
	{
		const std::string probe =
		    write("probe.json", R"({"sheets":[{"to_sheet":{"normal":[1,0,0]}},{)" + wishes + "}]}");
		EXPECT_TRUE(isQuiet(run(Arguments{"render", "demo:shell:16"} + out + Arguments{probe}))) << wishes;
		return contents(path("out.png"));
	};
	const std::string plain = picture("");
	for (const char* wish :
	     {R"("opacity":0.4)", R"("colormap":"turbo")", R"("colormap":"grey_r")", R"("range":[-0.2,0.2])",
	      R"("lines":6)", R"("array":"v")", R"("window":[2,2])", R"("window":[2,2],"fx":{"magnification":2})"})
		EXPECT_NE(picture(wish), plain) << wish;
	EXPECT_NE(picture(R"("window":[2,2])"), picture(R"("window":[2,2],"fx":{"magnification":2})"));
}

TEST_F(Render, NoMoreSheetsThanAPictureTakes)
{
	const auto stack = [&](const char* sheets)
	{
		return run({"render", "demo:shell:8", "--probe", "stack", "--sheets", sheets, "-o", path("out.png"), "--size",
		            "64x64"});
	};
	EXPECT_TRUE(isQuiet(stack("16")));
	std::filesystem::remove(path("out.png"));
	EXPECT_TRUE(isError(stack("17"), 1, {"17", "16"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(Render, LogarithmicColors)
{
	const Arguments out{"-o", path("out.png"), "--size", "64x64", "--log"};
	// s has values of both signs, v magnitude is above 0 everywhere.
	EXPECT_TRUE(isDoneWithAWord(render(out), {"--log", "'s'", "0 or below"}));
	EXPECT_TRUE(isQuiet(render(out + Arguments{"--array", "v"})));
	EXPECT_TRUE(isQuiet(render(out + Arguments{"--array", "v", "--range", "0.1", "10", "--lines", "5"})));
	std::filesystem::remove(path("out.png"));
	const std::string negative =
	    write("negative.vtk", "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\n"
	                          "DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8\n"
	                          "SCALARS depth float 1\nLOOKUP_TABLE default\n"
	                          "-1 -2 -3 -4 -5 -6 -7 0\n");
	EXPECT_TRUE(isError(run(Arguments{"render", negative} + out), 2, {"--log", "'depth'", "--array"}));
	const std::string bare = write("bare.vtk", "# vtk DataFile Version 3.0\n\nASCII\nDATASET STRUCTURED_POINTS\n"
	                                           "DIMENSIONS 2 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n");
	EXPECT_TRUE(isError(run(Arguments{"render", bare} + out), 2, {"bare.vtk", "--log"}));
	EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

// It is the traversal's own: the same whoever classifies.
TEST_F(Render, ColorsOfGenerations)
{
	const auto picture = [&](const Arguments& options)
	{
		const std::string name = path("out.png");
		EXPECT_TRUE(isQuiet(render(Arguments{"-o", name, "--size", "200x120"} + options))) << options.front();
		return contents(name);
	};
	const Arguments by{"--color-by", "generation", "--seeds", "hotspot", "--origin", "0", "2", "0"};
	const std::string gpu = picture(by + Arguments{"--classify", "gpu"});
	EXPECT_TRUE(gpu == picture(by + Arguments{"--classify", "cpu"}));
	EXPECT_TRUE(gpu != picture({"--seeds", "hotspot", "--origin", "0", "2", "0"}));
	EXPECT_TRUE(gpu != picture({"--color-by", "generation", "--origin", "0", "2", "0"}));
}

TEST_F(Render, PlaneThatMissesTheGrid)
{
	const Outcome outcome = run({"render", "demo:shell:8", "--origin", "100", "0", "0", "--normal", "x", "-o",
	                             path("out.png"), "--size", "64x64"});
	EXPECT_TRUE(isDoneWithAWord(outcome, {"empty"}));
	EXPECT_EQ(sizeOf(contents(path("out.png"))), (PictureSize{64, 64}));
}

TEST_F(Render, CannotBeWritten)
{
	std::filesystem::create_directory(path("out.png"));
	EXPECT_TRUE(isError(render({"-o", path("out.png"), "--size", "64x64"}), 4, {path("out.png")}));
	EXPECT_EQ(files(), Arguments{"out.png"});
}

TEST_F(Render, UnusableInput)
{
	EXPECT_TRUE(isError(run({"render", path("absent.vtu"), "-o", path("out.png")}), 2, {"absent.vtu"}));
	EXPECT_TRUE(
	    isError(run({"render", "demo:shell:8", "--array", "depth", "-o", path("out.png")}), 2, {"depth", "s", "v"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
