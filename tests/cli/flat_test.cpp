#include "program.h"
#include "small_font.h"

#include <filesystem>
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
	// 1 000 000 000 seconds after 1970
	Surroundings dated = noDevice();
	dated.environment["SOURCE_DATE_EPOCH"] = "1000000000";
	ASSERT_TRUE(isQuiet(run({"slice", "demo:shell:8", "--classify", "cpu", "-o", path("a.pdf")}, dated)));
	EXPECT_TRUE(contains(contents(path("a.pdf")), "20010909014640"));
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

TEST_F(Flat, PicturesForPapers)
{
	const auto picture = [&](const Arguments& options)
	{
		EXPECT_TRUE(isQuiet(slice(Arguments{"-o", path("p.png"), "--size", "500x300"} + options)));
		return contents(path("p.png"));
	};
	const std::string plain = picture({});
	for (const Arguments& options : {Arguments{"--text-size", "9pt"}, Arguments{"--no-footer"}, Arguments{"--no-inset"},
	                                 Arguments{"--legend-title", "T / K"},
	                                 Arguments{"--font", write("f.ttf", vp::test::smallFont("F", {'0', 's'}))}})
		EXPECT_NE(plain, picture(options)) << options[0];
	EXPECT_EQ(picture({"--text-size", "9pt"}), picture({"--text-size", "12"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.png"), "--text-size", "9mm"}), 1, {"--text-size", "9mm", "9pt"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.png"), "--font", "No Such Family"}), 2, {"--font", "No Such Family"}));
	EXPECT_TRUE(isError(slice({"-o", path("x.png"), "--font", path("no.ttf")}), 2, {"--font", "no.ttf"}));
}

// Two letters that only the one installed font has: boxes of their em. Without it one line names them.
TEST_F(Flat, LettersOfOtherScripts)
{
	std::filesystem::create_directory(path("fonts"));
	write("fonts/small.ttf", vp::test::smallFont("Small Boxes", {0x65ad, 0x9762}));
	Surroundings with = noDevice();
	with.environment["FONTCONFIG_FILE"] =
	    write("with.conf", "<?xml version=\"1.0\"?><fontconfig><dir>" + path("fonts") + "</dir><cachedir>" +
	                           path("cache") + "</cachedir></fontconfig>");
	Surroundings without = noDevice();
	without.environment["FONTCONFIG_FILE"] = write("without.conf", "<?xml version=\"1.0\"?><fontconfig><cachedir>" +
	                                                                   path("cache") + "</cachedir></fontconfig>");
	const Arguments titled{"slice",   "demo:shell:8", "--classify", "cpu", "--size",
	                       "500x300", "--title",      "断面 μ",     "-o",  path("t.svg")};
	EXPECT_TRUE(isQuiet(run(titled, with)));
	const std::string boxes = contents(path("t.svg"));
	EXPECT_TRUE(isDoneWithAWord(run(titled, without),
	                            {"vprobe: warning: no installed font", "断面", "U+65AD", "U+9762", "--font"}));
	EXPECT_NE(boxes, contents(path("t.svg")));
}

// Cells have the mean color at their points, so colors no longer jump.
TEST_F(Flat, CellsAreSmoothedToPoints)
{
	const std::string file = write("two.vtk", "# vtk DataFile Version 3.0\ntwo\nASCII\nDATASET STRUCTURED_POINTS\n"
	                                          "DIMENSIONS 3 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\nCELL_DATA 2\n"
	                                          "SCALARS heat float 1\nLOOKUP_TABLE default\n1 4\n");
	const auto table = [&](const Arguments& options)
	{
		const Outcome done = run(Arguments{"slice", file, "--classify", "cpu", "--normal", "z", "-o", "-"} + options);
		EXPECT_EQ(done.status, 0) << done.err;
		return done.out;
	};
	EXPECT_NE(table({}), table({"--cell-to-point"}));
	const Outcome line =
	    run({"slice", file, "--classify", "cpu", "--cell-to-point", "--line", "-1", "0", "1", "0", "-o", "-"});
	EXPECT_TRUE(contains(line.out, ",2.5")) << line.out; // in the middle, by hand (1 + 4) / 2
	EXPECT_TRUE(isError(run({"convert", file, "--cell-to-point", "-o", path("x.vtu")}), 1, {"--cell-to-point"}));
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
