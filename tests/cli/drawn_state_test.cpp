#include "program.h"

namespace cli
{

namespace
{

class DrawnState : public Drawing
{
};

} // namespace

TEST_F(DrawnState, DrawsTheSamePicture)
{
	const Arguments look{"render",
	                     "demo:shell:12",
	                     "--probe",
	                     "paddlewheel",
	                     "--size",
	                     "160x100",
	                     "--samples",
	                     "2",
	                     "--opacity",
	                     "0.6",
	                     "--colormap",
	                     "turbo",
	                     "--range",
	                     "-0.3",
	                     "0.4",
	                     "--range-of",
	                     "slice",
	                     "--symmetric",
	                     "--no-legend",
	                     "--camera",
	                     "1",
	                     "2",
	                     "3",
	                     "0",
	                     "0.5",
	                     "0",
	                     "0",
	                     "0",
	                     "1",
	                     "--background",
	                     "#123456",
	                     "--title",
	                     "",
	                     "--outline",
	                     "edges",
	                     "--context",
	                     "boundary",
	                     "--context",
	                     "boundary:0.3"};
	ASSERT_TRUE(isQuiet(run(look + Arguments{"-o", path("a.png"), "--save", path("a.json")})));
	ASSERT_TRUE(isQuiet(run({"render", "--state", path("a.json"), "-o", path("b.png"), "--save", path("b.json")})));
	EXPECT_TRUE(contents(path("a.png")) == contents(path("b.png")));
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
	// Through a command that does not draw, the look stays in it.
	ASSERT_EQ(run({"slice", "--state", path("a.json"), "--save", path("c.json")}).status, 0);
	EXPECT_EQ(contents(path("a.json")), contents(path("c.json")));
	ASSERT_TRUE(isQuiet(run({"render", "--state", path("a.json"), "--opacity", "1", "-o", path("d.png")})));
	EXPECT_TRUE(contents(path("a.png")) != contents(path("d.png")));
}

TEST_F(DrawnState, SweepsTheSamePath)
{
	const std::string keys = write("keys.json", R"({"path": "keyframes", "keys": [
		{"at": 0, "to_probe": {"origin": [1, 0, 0], "normal": [1, 0, 0]}},
		{"at": 1.1, "to_probe": {"origin": [1, 1, 0.1], "normal": [0, 1, 0.3]}}]})");
	ASSERT_TRUE(isQuiet(run({"sweep", "demo:shell:12", "--path", keys, "--frames", "3", "--there-and-back", "--size",
	                         "96x64", "-o", path("a{frame}.png"), "--save", path("a.json")})));
	std::filesystem::remove(keys);
	ASSERT_TRUE(
	    isQuiet(run({"sweep", "--state", path("a.json"), "-o", path("b{frame}.png"), "--save", path("b.json")})));
	EXPECT_EQ(contents(path("a.json")), contents(path("b.json")));
	for (const char* k : {"0", "1", "2"})
	{
		const std::string frame = contents(path(std::string("a") + k + ".png"));
		EXPECT_EQ(sizeOf(frame), (PictureSize{96, 64}));
		EXPECT_TRUE(frame == contents(path(std::string("b") + k + ".png"))) << k;
	}
}

} // namespace cli
