// Pictures of contours that grow from sheets.

#include "program.h"

namespace cli
{

namespace
{

using nlohmann::json;

const Arguments kDrawnSheet{"demo:blob:16", "--normal", "0.3 0.5 0.81", "--window", "3", "2"};

class DrawnContour : public Drawing
{
protected:
	std::string drawn(const Arguments& options) const
	{
		EXPECT_TRUE(isQuiet(run(Arguments{"render", "-o", path("out.png"), "--size", "240x160", "--samples", "1"} +
		                        kDrawnSheet + options)));
		const std::string png = contents(path("out.png"));
		EXPECT_EQ(sizeOf(png), (PictureSize{240, 160}));
		return png;
	}
};

} // namespace

TEST_F(DrawnContour, IsSeen)
{
	const std::string sheet = drawn({});
	const std::string one = drawn({"--contour", "0.2"});
	EXPECT_NE(one, sheet);
	EXPECT_EQ(drawn({"--contour", "0.2"}), one);
	EXPECT_NE(drawn({"--contour", "0.2", "-0.4"}), one);
	EXPECT_NE(drawn({"--contour", "0.2", "--contour-opacity", "0.4"}), one);
	EXPECT_NE(drawn({"--contour", "0.2", "--contour-depth", "0.2"}), one);
	EXPECT_EQ(drawn({"--contour", "0.2", "--contour-opacity", "0"}), sheet);
}

TEST_F(DrawnContour, OfASweep)
{
	const Outcome sweep = run(Arguments{"sweep"} + kDrawnSheet +
	                          Arguments{"--path", "spin", "--frames", "3", "--contour", "0.2", "--size", "120x80",
	                                    "--samples", "1", "-o", path("{frame}.png"), "--stats", "-"});
	ASSERT_EQ(sweep.status, 0) << sweep.err;
	const json frames = sweep.json().at("frames");
	ASSERT_EQ(frames.size(), 3u);
	for (const json& frame : frames)
		EXPECT_EQ(frame.at("contours").size(), 1u);
	EXPECT_TRUE(isError(run({"sweep", "demo:blob:4", "--contour", "0", "--array", "v", "--surface", "sphere:1", "-o",
	                         path("none.png")}),
	                    1, {"--contour"}));
}

} // namespace cli
