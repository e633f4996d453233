#include "program.h"

#include <sstream>

namespace cli
{

namespace
{

class Flat : public Program
{
protected:
	// Runs the program without a Vulkan device, since it needs none.
	Outcome slice(const Arguments& arguments) const
	{
		return run(Arguments{"slice", "demo:shell:8", "--classify", "cpu"} + arguments, noDevice());
	}
};

} // namespace

TEST_F(Flat, PicturesNeedNoDevice)
{
	ASSERT_TRUE(isQuiet(slice({"-o", path("a.png"), "--size", "640x360", "--lines", "7", "--mesh", "--bands", "4",
	                           "--colormap", "turbo", "--title", "T", "--units", "K", "--length-units", "m"})));
	EXPECT_EQ(sizeOf(contents(path("a.png"))), (PictureSize{640, 360}));
	ASSERT_TRUE(isQuiet(slice({"-o", path("a.SVG"), "--normal", "1", "1", "0.2"})));
	EXPECT_TRUE(contains(contents(path("a.SVG")), "</svg>"));
	ASSERT_TRUE(isQuiet(slice({"-o", path("a.pdf"), "--color-by", "generation"})));
	EXPECT_TRUE(contains(contents(path("a.pdf")), "%%EOF"));
	EXPECT_EQ(files(), (Arguments{"a.SVG", "a.pdf", "a.png"}));
}

TEST_F(Flat, OptionsChangeThePicture)
{
	const auto picture = [&](const Arguments& options)
	{
		EXPECT_TRUE(isQuiet(slice(Arguments{"-o", path("p.png"), "--size", "500x300"} + options)));
		return contents(path("p.png"));
	};
	const std::string plain = picture({});
	EXPECT_EQ(plain, picture({}));
	EXPECT_EQ(plain, picture({"--background", "white"}));
	const std::string lines = picture({"--lines", "6"});
	EXPECT_NE(lines, plain);
	EXPECT_NE(lines, picture({"--lines", "6", "--no-labels"}));
	EXPECT_EQ(plain, picture({"--no-labels"}));
	for (const Arguments& options :
	     {Arguments{"--background", "gradient"}, Arguments{"--units", "K"}, Arguments{"--length-units", "m"},
	      Arguments{"--title", ""}, Arguments{"--mesh"}, Arguments{"--range", "-1", "1"}, Arguments{"--camera", "x"}})
		EXPECT_NE(plain, picture(options)) << options[0];
}

TEST_F(Flat, RoundingIsNotWrittenDown)
{
	const auto picture = [&](const char* x)
	{
		EXPECT_TRUE(isQuiet(slice({"-o", path("p.png"), "--size", "500x300", "--origin", x, "1.5", "0.1"})));
		return contents(path("p.png"));
	};
	const std::string plain = picture("0");
	EXPECT_EQ(plain, picture("2e-8"));
	EXPECT_EQ(plain, picture("-2e-8"));
	EXPECT_NE(plain, picture("0.001"));
}

TEST_F(Flat, SeveralSheetsHaveAFileEach)
{
	ASSERT_TRUE(isQuiet(slice({"--probe", "trihedral", "-o", path("s{sheet}.png"), "--size", "300x200"})));
	EXPECT_EQ(files(), (Arguments{"s0.png", "s1.png", "s2.png"}));
	EXPECT_TRUE(isError(slice({"--probe", "trihedral", "-o", path("s.png")}), 1, {"s.png", "{sheet}"}));
	EXPECT_EQ(files().size(), 3u);
}

TEST_F(Flat, HiddenSheetsHaveNone)
{
	const std::string probe = write("p.json", R"({"sheets": [{"hidden": true}]})");
	EXPECT_EQ(slice({"--probe", probe, "-o", path("x.png")}).status, 0);
	EXPECT_EQ(slice({"--probe", probe, "--stats", "-"}).status, 0);
	EXPECT_TRUE(
	    isError(slice({"--probe", probe, "--line", "0", "0", "1", "1", "-o", path("l.csv")}), 1, {"--sheet 0"}));
	EXPECT_EQ(files(), (Arguments{"p.json"}));
}

TEST_F(Flat, LooksAreRefusedWhereNothingIsDrawn)
{
	EXPECT_TRUE(isError(slice({"-o", path("x.vtp"), "--lines", "5"}), 1, {"--lines", "x.vtp", ".png"}));
	EXPECT_TRUE(isError(slice({"--mesh"}), 1, {"--mesh", "-o"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.png"), "--lit"}), 1, {"--lit"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.png"), "--size", "9"}), 1, {"--size"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.jpg")}), 1, {"x.jpg", ".png", ".svg"}));
	EXPECT_TRUE(files().empty());
}

// The look in a state is allowed when polygons are written.
TEST_F(Flat, LooksOfAStateAreKept)
{
	ASSERT_TRUE(isQuiet(slice({"-o", path("a.png"), "--lines", "5", "--no-labels", "--units", "K", "--length-units",
	                           "m", "--save", path("s.json")})));
	const auto state = nlohmann::json::parse(contents(path("s.json")));
	EXPECT_EQ(state.at("look").at("units"), "K");
	EXPECT_EQ(state.at("look").at("length_units"), "m");
	EXPECT_EQ(state.at("look").at("no_labels"), true);
	ASSERT_TRUE(
	    isQuiet(run({"slice", "--state", path("s.json"), "--classify", "cpu", "-o", path("b.png")}, noDevice())));
	EXPECT_EQ(contents(path("a.png")), contents(path("b.png")));
	EXPECT_TRUE(
	    isQuiet(run({"slice", "--state", path("s.json"), "--classify", "cpu", "-o", path("b.vtp")}, noDevice())));
}

TEST_F(Flat, ValuesAlongALine)
{
	const Outcome outcome = slice({"--line", "-4", "0.5", "4", "0.5", "-o", "-"});
	ASSERT_EQ(outcome.status, 0) << outcome.err;
	std::istringstream lines(outcome.out);
	std::string line;
	std::getline(lines, line);
	EXPECT_EQ(line, "distance,u,v,x,y,z,block,cell,s,v_x,v_y,v_z");
	std::getline(lines, line);
	EXPECT_EQ(line, "0,-4,0.5,-4,2,0,nan,nan,nan,nan,nan,nan");
	ASSERT_TRUE(
	    isQuiet(slice({"--probe", "trihedral", "--line", "-1", "0", "1", "0", "--sheet", "2", "-o", path("l.csv")})));
	EXPECT_TRUE(contains(contents(path("l.csv")), "distance,u,v"));
}

TEST_F(Flat, WrongLines)
{
	EXPECT_TRUE(isError(slice({"--line", "0", "0", "1", "1", "-o", path("l.vtp")}), 1, {"--line", ".csv"}));
	EXPECT_TRUE(isError(slice({"--line", "0", "0", "1", "1"}), 1, {"--line", ".csv"}));
	EXPECT_TRUE(isError(slice({"--line", "1", "2", "1", "2", "-o", path("l.csv")}), 1, {"--line"}));
	EXPECT_TRUE(isError(slice({"--line", "1", "nan", "1", "2", "-o", path("l.csv")}), 1, {"--line"}));
	EXPECT_TRUE(isError(slice({"--line", "-1e308", "0", "1e308", "0", "-o", path("l.csv")}), 1, {"--line", "1e100"}));
	EXPECT_TRUE(isError(slice({"--line", "1", "2", "-o", path("l.csv")}), 1, {"--line"}));
	EXPECT_TRUE(isError(slice({"--line", "0", "0", "1", "1", "--sheet", "1", "-o", path("l.csv")}), 1, {"--sheet 1"}));
	EXPECT_TRUE(isError(slice({"--sheet", "1", "-o", path("l.csv")}), 1, {"--sheet", "--line"}));
	EXPECT_TRUE(files().empty());
}

} // namespace cli
