// Pictures of what is not flat: grid surfaces, whole cells, grid surfaces around a plane.

#include "program.h"

namespace cli
{

namespace
{

class DrawnSurface : public Drawing
{
protected:
	// A small picture; fails the test where it is none.
	std::string drawn(const Arguments& options) const
	{
		const Outcome outcome = run(Arguments{"render", "demo:shell:12", "--size", "240x160", "--samples", "1",
		                                      "--title", "", "-o", path("out.png")} +
		                            options);
		EXPECT_TRUE(isQuiet(outcome));
		const std::string png = contents(path("out.png"));
		EXPECT_EQ(sizeOf(png), (PictureSize{240, 160}));
		return png;
	}
};

} // namespace

TEST_F(DrawnSurface, DependsOnTheIndex)
{
	const std::string inner = drawn({"--surface", "i=2"});
	EXPECT_EQ(drawn({"--surface", "i=2"}), inner);
	EXPECT_NE(drawn({"--surface", "i=10.5"}), inner);
	EXPECT_NE(drawn({"--surface", "j=2"}), inner);
	EXPECT_NE(drawn({"--surface", "i=2", "--array", "v"}), inner);
	EXPECT_NE(drawn({"--surface", "i=2", "--mesh"}), inner);
	EXPECT_NE(drawn({"--surface", "i=2", "--opacity", "0.5"}), inner);
}

TEST_F(DrawnSurface, OfWholeCells)
{
	const std::string plane = drawn({"--normal", "z"});
	EXPECT_NE(drawn({"--normal", "z", "--crinkle"}), plane);
	EXPECT_NE(drawn({"--surface", "i=2.5", "--crinkle"}), drawn({"--surface", "i=2.5"}));
}

TEST_F(DrawnSurface, AroundAPlane)
{
	const std::string plane = drawn({"--normal", "z"});
	const std::string within = drawn({"--normal", "z", "--context", "i=3.5"});
	EXPECT_NE(within, plane);
	EXPECT_NE(drawn({"--normal", "z", "--context", "i=3.5:0.9"}), within);
	for (const auto& [context, status, word] : {std::tuple{"i=13", 1, "0 to 12"}, std::tuple{"i=x", 1, "--context i=x"},
	                                            std::tuple{"i=1..2", 1, "one index"}})
		EXPECT_TRUE(isError(run({"render", "demo:shell:12", "--context", context, "-o", path("none.png")}), status,
		                    {"--context", word}))
		    << context;
	EXPECT_TRUE(
	    isError(run({"render", "demo:tets:4", "--context", "i=1", "-o", path("none.png")}), 2, {"--context i=1"}));
	EXPECT_FALSE(std::filesystem::exists(path("none.png")));
}

TEST_F(DrawnSurface, HasNoGenerationsAndNoFront)
{
	EXPECT_TRUE(
	    isError(run({"render", "demo:shell:8", "--surface", "i=2", "--color-by", "generation", "-o", path("none.png")}),
	            1, {"--color-by generation", "--surface i=2"}));
	EXPECT_TRUE(
	    isError(run({"render", "demo:shell:8", "--surface", "i=2", "--camera", "sheet", "-o", path("none.png")}), 1,
	            {"--camera sheet"}));
	EXPECT_TRUE(files().empty());
}

TEST_F(DrawnSurface, SweepsIntoPictures)
{
	const Outcome swept = run({"sweep", "demo:shell:8", "--surface", "i=0..8", "--frames", "3", "--size", "160x120",
	                           "--samples", "1", "-o", path("f{frame}.png")});
	ASSERT_EQ(swept.status, 0) << swept.err;
	EXPECT_NE(contents(path("f0.png")), contents(path("f1.png")));
	EXPECT_NE(contents(path("f1.png")), contents(path("f2.png")));
}

} // namespace cli
