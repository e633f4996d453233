#include "program.h"

namespace cli
{

namespace
{

class Usage : public Program
{
};

// Values that cannot be, for options of the commands that cut.
struct BadUsage
{
	const char* name;
	Arguments arguments;
	std::string word; // the error line holds it
};

void PrintTo(const BadUsage& bad, std::ostream* stream)
{
	*stream << bad.name;
}

class BadProbe : public Program, public testing::WithParamInterface<BadUsage>
{
};
class BadLook : public Program, public testing::WithParamInterface<BadUsage>
{
};

std::string name(const testing::TestParamInfo<BadUsage>& info)
{
	return info.param.name;
}

} // namespace

TEST_F(Usage, HelpOfEveryCommand)
{
	EXPECT_TRUE(isQuiet(run({"--help"})));
	for (const std::string command : {"info", "slice", "render", "sweep", "profile", "check", "sample", "convert"})
	{
		EXPECT_TRUE(contains(run({"--help"}).out, command));
		const Outcome help = run({command, "--help"});
		EXPECT_TRUE(isQuiet(help)) << command;
		EXPECT_TRUE(contains(help.out, "INPUT")) << command << "\n" << help.out;
	}
}

TEST_F(Usage, HelpNamesTheOptions)
{
	const std::string info = run({"info", "--help"}).out;
	for (const char* option : {"--json", "--time", "--solution", "--refine"})
		EXPECT_TRUE(contains(info, option)) << option;
	const std::string slice = run({"slice", "--help"}).out;
	const std::string render = run({"render", "--help"}).out;
	for (const char* option : {"--origin", "--normal", "--up", "--array", "--component", "--time", "--solution",
	                           "--seeds", "--outside", "--classify", "--device", "--threads", "--threshold"})
	{
		EXPECT_TRUE(contains(slice, option)) << option;
		EXPECT_TRUE(contains(render, option)) << option;
	}
	EXPECT_TRUE(contains(slice, "--stats"));
	for (const char* option : {"--size", "--samples", "--colormap", "--range", "--range-of", "--symmetric",
	                           "--no-legend", "--log", "--opacity", "--lines", "--bands", "--mesh", "--lit", "--camera",
	                           "--background", "--outline", "--axes", "--title", "NAME_r"})
		EXPECT_TRUE(contains(render, option)) << option;
}

TEST_F(Usage, Version)
{
	const Outcome version = run({"--version"});
	EXPECT_TRUE(isQuiet(version));
	EXPECT_TRUE(contains(version.out, "vprobe ")) << version.out;
	// It tells what holds the readers here.
	const std::string second = version.out.substr(version.out.find('\n') + 1);
	EXPECT_TRUE(contains(second, "sandbox: ") && contains(second, "seccomp")) << version.out;
	EXPECT_TRUE(contains(run({"--version"}, {.environment = {{"VPROBE_SANDBOX", "off"}}}).out, "sandbox: nothing"));
}

TEST_F(Usage, NoCommand)
{
	EXPECT_TRUE(isError(run({}), 1, {"--help"}));
}

TEST_F(Usage, UnknownCommand)
{
	EXPECT_TRUE(isError(run({"slize", "demo:shell:8"}), 1, {"slize", "--help"}));
}

TEST_F(Usage, UnknownOption)
{
	for (const std::string command : {"info", "slice", "render"})
		EXPECT_TRUE(isError(run({command, "demo:shell:8", "--nromal", "x"}), 1, {"--nromal", "--help"})) << command;
}

TEST_F(Usage, NoInput)
{
	EXPECT_TRUE(isError(run({"info"}), 1, {"INPUT"}));
	EXPECT_TRUE(isError(run({"slice", "--normal", "z"}), 1, {"INPUT"}));
	EXPECT_TRUE(isError(run({"render", "-o", path("out.png")}), 1, {"INPUT"}));
}

TEST_F(Usage, StandardOutputIsForOneThing)
{
	EXPECT_TRUE(
	    isError(run({"slice", "demo:shell:8", "--classify", "cpu", "-o", "-", "--stats", "-"}), 1, {"--stats", "-o"}));
}

TEST_F(Usage, OutputOfAnUnknownKind)
{
	for (const std::string output : {"out.xyz", "out", "out.jpg"})
	{
		EXPECT_TRUE(isError(run({"slice", "demo:shell:8", "--classify", "cpu", "-o", path(output)}), 1,
		                    {output, ".vtp", ".ply", ".csv"}))
		    << output;
		EXPECT_TRUE(files().empty()) << output;
	}
}

TEST_F(Usage, PictureOfAnUnknownKind)
{
	EXPECT_TRUE(isError(run({"render", "demo:shell:8", "-o", path("out.vtp")}), 1, {"out.vtp", ".png"}));
	EXPECT_TRUE(files().empty());
}

TEST_P(BadProbe, IsOneLineAndLeavesNothing)
{
	for (const Arguments& command :
	     {Arguments{"slice", "demo:shell:8", "-o", path("out.vtp"), "--stats", path("out.json")},
	      Arguments{"render", "demo:shell:8", "-o", path("out.png")}})
	{
		EXPECT_TRUE(isError(run(command + GetParam().arguments, noDevice()), 1, {GetParam().word})) << command.front();
		EXPECT_TRUE(files().empty());
	}
}

INSTANTIATE_TEST_SUITE_P(
    All, BadProbe,
    testing::Values(BadUsage{"zeroNormal", {"--normal", "0", "0", "0"}, "--normal"},
                    BadUsage{"wordAsNormal", {"--normal", "up"}, "--normal"},
                    BadUsage{"twoNumbersAsNormal", {"--normal", "1", "0"}, "--normal"},
                    BadUsage{"normalNotANumber", {"--normal", "nan", "0", "1"}, "--normal"},
                    BadUsage{"endlessNormal", {"--normal", "inf", "0", "1"}, "--normal"},
                    BadUsage{"normalLeftOut", {"--normal"}, "--normal"},
                    BadUsage{"wordAsOrigin", {"--origin", "a", "b", "c"}, "--origin"},
                    BadUsage{"twoNumbersAsOrigin", {"--origin", "1", "2"}, "--origin"},
                    BadUsage{"originNotANumber", {"--origin", "nan", "0", "0"}, "--origin"},
                    BadUsage{"endlessOrigin", {"--origin", "0", "inf", "0"}, "--origin"},
                    BadUsage{"zeroUp", {"--up", "0", "0", "0"}, "--up"},
                    BadUsage{"classifier", {"--classify", "fpga"}, "--classify"},
                    BadUsage{"seeds", {"--seeds", "many"}, "--seeds"},
                    BadUsage{"outside", {"--outside", "never"}, "--outside"},
                    BadUsage{"time", {"--time", "yesterday"}, "--time"},
                    BadUsage{"emptyTime", {"--time", ""}, "--time"}, BadUsage{"timeIndex", {"--time", "#x"}, "--time"},
                    BadUsage{"component", {"--component", "w"}, "--component"},
                    BadUsage{"noWidth", {"--window-level", "0", "40"}, "--window-level"},
                    BadUsage{"noFolder", {"--follow", "absent"}, "no such folder"},
                    BadUsage{"thresholdUpsideDown", {"--threshold", "2", "1"}, "--threshold"},
                    BadUsage{"thresholdNotANumber", {"--threshold", "0", "nan"}, "--threshold"},
                    BadUsage{"thresholdOfOne", {"--threshold", "0"}, "--threshold"},
                    BadUsage{"negativeComponent", {"--component", "-1"}, "--component"},
                    BadUsage{"threads", {"--threads", "-1"}, "--threads"},
                    BadUsage{"threadsInWords", {"--threads", "two"}, "--threads"},
                    BadUsage{"deviceMemory", {"--device-memory", "-1"}, "--device-memory"},
                    BadUsage{"deviceMemoryInWords", {"--device-memory", "much"}, "--device-memory"}),
    name);

TEST_P(BadLook, IsOneLineAndLeavesNothing)
{
	EXPECT_TRUE(isError(run(Arguments{"render", "demo:shell:8", "-o", path("out.png")} + GetParam().arguments), 1,
	                    {GetParam().word}));
	EXPECT_TRUE(files().empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, BadLook,
    testing::Values(
        BadUsage{"zeroSize", {"--size", "0x10"}, "--size"}, BadUsage{"sizeInWords", {"--size", "big"}, "--size"},
        BadUsage{"hugeSize", {"--size", "1000000x1000000"}, "--size"},
        BadUsage{"colormap", {"--colormap", "no-such-map"}, "--colormap"},
        BadUsage{"rangeUpsideDown", {"--range", "2", "1"}, "--range"},
        BadUsage{"rangeOfWhat", {"--range-of", "sheet"}, "--range-of"},
        BadUsage{"symmetricLogarithm", {"--log", "--symmetric"}, "--symmetric"},
        BadUsage{"rangeNotANumber", {"--range", "nan", "1"}, "--range"},
        BadUsage{"camera", {"--camera", "nowhere"}, "--camera"},
        BadUsage{"cameraOfFourNumbers", {"--camera", "1", "2", "3", "4"}, "--camera"},
        BadUsage{"logOfNothing", {"--log", "--range", "0", "1"}, "--range"},
        BadUsage{"opacityAboveOne", {"--opacity", "1.5"}, "--opacity"},
        BadUsage{"negativeOpacity", {"--opacity", "-0.1"}, "--opacity"},
        BadUsage{"opacityNotANumber", {"--opacity", "nan"}, "--opacity"},
        BadUsage{"opacityInWords", {"--opacity", "half"}, "--opacity"},
        BadUsage{"negativeLines", {"--lines", "-1"}, "--lines"},
        BadUsage{"tooManyLines", {"--lines", "100000"}, "--lines"},
        BadUsage{"linesInWords", {"--lines", "few"}, "--lines"},
        BadUsage{"unknownContext", {"--context", "walls"}, "boundary[:OPACITY]"},
        BadUsage{"contextOpacityAboveOne", {"--context", "boundary:1.5"}, "--context boundary:1.5"},
        BadUsage{"contextOpacityNotANumber", {"--context", "boundary:nan"}, "--context boundary:nan"},
        BadUsage{"contextOpacityInWords", {"--context", "boundary:half"}, "--context boundary:half"},
        BadUsage{"contextArgument", {"--context", "boundary=3"}, "--context boundary=3"},
        BadUsage{"noContext", {"--context", ""}, "--context"}, BadUsage{"bandsNotWhole", {"--bands", "2.5"}, "--bands"},
        BadUsage{"axes", {"--axes", "round"}, "--axes"}, BadUsage{"samples", {"--samples", "0"}, "--samples"},
        BadUsage{"outline", {"--outline", "sphere"}, "--outline"},
        BadUsage{"reversedNothing", {"--colormap", "jet_r"}, "jet_r"},
        BadUsage{"background", {"--background", "no-such-color"}, "--background"}),
    name);

} // namespace cli
