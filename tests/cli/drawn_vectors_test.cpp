#include "program.h"

#include <filesystem>

namespace cli
{

namespace
{

class DrawnVectors : public Drawing
{
protected:
	const Arguments small{"--size", "160x100", "--samples", "1", "--background", "white", "--title", ""};

	std::string picture(const Arguments& options) const
	{
		const std::string name = path("out.png");
		EXPECT_TRUE(isQuiet(run(Arguments{"render", "demo:shell:12", "-o", name} + small + options)));
		return contents(name);
	}
};

} // namespace

TEST_F(DrawnVectors, EveryOptionIsSeen)
{
	const Arguments tufts{"--vectors", "tufts"};
	const std::string plain = picture(tufts);
	EXPECT_TRUE(plain != picture({}));
	EXPECT_TRUE(plain == picture(tufts));
	for (const Arguments& options :
	     {Arguments{"--vectors", "lines"}, Arguments{"--vectors", "ribbons"}, Arguments{"--vectors", "tubes"},
	      tufts + Arguments{"--vector-color", "s"}, tufts + Arguments{"--vector-color", "#ff0000"},
	      tufts + Arguments{"--vector-colormap", "cividis"}, tufts + Arguments{"--vector-width", "0.05"},
	      tufts + Arguments{"--vector-opacity", "0.3"}, tufts + Arguments{"--vector-lattice", "9"},
	      tufts + Arguments{"--vector-jitter", "1"}, tufts + Arguments{"--vector-steps", "3.5"},
	      tufts + Arguments{"--vector-dt", "0.5"}, tufts + Arguments{"--vector-direction", "backward"},
	      tufts + Arguments{"--vector-part", "normal"}})
		EXPECT_TRUE(picture(options) != plain) << options[options.size() - 2];
	EXPECT_TRUE(picture(tufts + Arguments{"--vector-opacity", "0", "--vector-color", "black"}) == picture({}));
}

TEST_F(DrawnVectors, AStateBringsThemBack)
{
	const Arguments look{"--vectors",      "tubes", "--vector-color",   "point:s", "--vector-colormap", "turbo",
	                     "--vector-width", "0.03",  "--vector-opacity", "0.75",    "--vector-steps",    "10"};
	const std::string drawn = picture(look + Arguments{"--save", path("a.json")});
	ASSERT_TRUE(isQuiet(run({"render", "--state", path("a.json"), "-o", path("b.png"), "--save", path("b.json")})));
	EXPECT_TRUE(drawn == contents(path("b.png")));
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
}

TEST_F(DrawnVectors, MoveWithASweep)
{
	const auto frame = [&](int number) { return contents(path("000" + std::to_string(number) + ".png")); };
	const Arguments sweep =
	    Arguments{"sweep", "demo:shell:12", "--frames", "3", "--vectors", "tufts", "--camera", "iso"} + small;
	ASSERT_TRUE(isQuiet(run(sweep + Arguments{"-o", path("{frame:04}.png"), "--stats", path("s.json")})));
	EXPECT_TRUE(frame(0) != frame(1));
	const std::string middle = frame(1);
	const auto figures = nlohmann::json::parse(contents(path("s.json")));
	for (const auto& shown : figures["frames"])
		EXPECT_EQ(shown["sheets"][0]["vectors"]["dt"], figures["frames"][0]["sheets"][0]["vectors"]["dt"]);
	// They are the same if only one frame is drawn.
	std::filesystem::remove(path("0001.png"));
	ASSERT_TRUE(isQuiet(run(sweep + Arguments{"-o", path("{frame:04}.png"), "--resume"})));
	EXPECT_TRUE(frame(1) == middle);
}

TEST_F(DrawnVectors, BadLooks)
{
	const auto refused = [&](const Arguments& options, int status, const std::vector<std::string>& words)
	{
		EXPECT_TRUE(
		    isError(run(Arguments{"render", "demo:shell:4", "-o", path("out.png"), "--vectors", "tufts"} + options),
		            status, words));
		EXPECT_TRUE(files().empty());
	};
	refused({"--vector-color", "depth"}, 2, {"--vector-color depth", "point:s", "#RRGGBB"});
	refused({"--vector-colormap", "mud"}, 1, {"--vector-colormap", "mud"});
	refused({"--vector-width", "0"}, 1, {"--vector-width 0", "above 0"});
	refused({"--vector-opacity", "1.5"}, 1, {"--vector-opacity"});
	refused({"--vector-opacity", "nan"}, 1, {"--vector-opacity"});
}

} // namespace cli
