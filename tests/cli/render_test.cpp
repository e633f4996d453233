#include "program.h"

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

TEST_F(Render, IsTheSameTwice)
{
	ASSERT_TRUE(isQuiet(render({"-o", path("a.png"), "--size", "200x120"})));
	ASSERT_TRUE(isQuiet(render({"-o", path("b.png"), "--size", "200x120"})));
	EXPECT_EQ(contents(path("a.png")), contents(path("b.png")));
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
	      Arguments{"--background", "white", "--camera", "x"}, Arguments{"--background", "white", "--array", "v"},
	      Arguments{"--background", "white", "--origin", "0", "1", "0"}})
		EXPECT_NE(picture(options), plain) << options[options.size() - 2];
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
	EXPECT_TRUE(isError(render({"-o", path("absent/out.png"), "--size", "64x64"}), 4, {path("absent/out.png")}));
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
