#include "desktop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

namespace view
{

namespace
{

class WindowOfTheDesktop : public Desktop
{
protected:
	vp::render::ColorMap map_ = *vp::render::makeColorMap("viridis");
	const Area left_{100, 100, 500, 450};
};

// 3 x 3 x 3 points with values from 0 to period - 1.
std::string smallImage(int period)
{
	std::string text = "# vtk DataFile Version 3.0\none\nASCII\nDATASET STRUCTURED_POINTS\n"
	                   "DIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 27\n"
	                   "SCALARS heat float 1\nLOOKUP_TABLE default\n";
	for (int i = 0; i < 27; ++i)
		text += std::to_string(i % period) + "\n";
	return text;
}

// Returns the size of a PNG, from its header.
glm::ivec2 sizeOfPng(const std::string& file)
{
	const std::string bytes = cli::contents(file);
	const auto number = [&](std::size_t at)
	{
		int value = 0;
		for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i)
			value = 256 * value + static_cast<unsigned char>(bytes[i]);
		return value;
	};
	return {number(16), number(20)};
}

} // namespace

TEST_F(WindowOfTheDesktop, FollowsItsSize)
{
	open({"demo:shell:16", "--normal", "z"});
	xdotool("windowsize --sync " + window() + " 1300 800\n");
	settle();
	const Area gained{kWidth, 100, 250, 600};
	EXPECT_TRUE(eventually(
	    [&]
	    {
		    return difference(seen(gained),
		                      part(vp::render::Picture{kScreenWidth, kScreenHeight,
		                                               std::vector<std::uint8_t>(std::size_t(4) * kScreenWidth *
		                                                                         kScreenHeight)},
		                           gained)) > 0.9;
	    }));
	command("size 800 500");
	settle();
	command("screenshot " + path("small.png"));
	ASSERT_TRUE(eventually(
	    [&] {
		    return cli::sizeOf(cli::contents(path("small.png"))) == cli::PictureSize{800, 500};
	    }));
	close();
}

TEST_F(WindowOfTheDesktop, ComesBackAsItWasAfterMinimizing)
{
	open({"demo:shell:16", "--normal", "z"});
	act("panels");
	settle();
	moveTo({5, 690});
	const vp::render::Picture before = rest(left_);
	xdotool("windowminimize " + window() + "\n");
	EXPECT_TRUE(eventually([&] { return shareOf(map_, seen(left_)) == 0.0; }));
	act("push_forward");
	act("push_back");
	settle();
	xdotool("windowmap " + window() + "\nwindowactivate " + window() + "\n");
	EXPECT_TRUE(eventually([&] { return difference(before, seen(left_)) == 0.0; }));
	command("minimise");
	command("restore");
	settle();
	EXPECT_TRUE(eventually([&] { return difference(before, seen(left_)) == 0.0; }));
	close();
}

TEST_F(WindowOfTheDesktop, ABadFileLeavesAllAsItWas)
{
	open({"demo:shell:16", "--normal", "z"});
	act("panels");
	const nlohmann::json before = settle();
	moveTo({5, 690});
	const vp::render::Picture picture = rest(left_);
	const std::string bad = write("bad file.vtk", "no grid at all\n");
	command("drop \"" + bad + "\"");
	EXPECT_EQ(settle(), before);
	EXPECT_TRUE(eventually([&] { return difference(picture, seen(left_)) == 0.0; }));
	const std::string said = err();
	EXPECT_TRUE(cli::contains(said, "bad file.vtk"));
	EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
	close(said);
}

TEST_F(WindowOfTheDesktop, AGoodFileTakesThePlaceOfTheOther)
{
	open({"demo:shell:16", "--normal", "z"});
	const std::string good = write("good.vtk", smallImage(7));
	command("drop " + good);
	const nlohmann::json state = settle();
	ASSERT_EQ(state["input"]["files"].size(), 1u) << state.dump(1);
	EXPECT_TRUE(cli::contains(state["input"]["files"][0], "good.vtk"));
	EXPECT_TRUE(eventually([&] { return shareOf(map_, seen(left_)) > 0.1; }));
	close();
}

TEST_F(WindowOfTheDesktop, AFileThatIsWrittenAnewIsReadAgain)
{
	const std::string file = write("solver.vtk", smallImage(7));
	open({file});
	act("panels");
	moveTo({5, 690});
	const vp::render::Picture before = rest(left_);
	write("solver.vtk", smallImage(2));
	EXPECT_TRUE(eventually([&] { return difference(before, seen(left_)) > 0.02; }));
	close();
}

TEST_F(WindowOfTheDesktop, SavesPictureAndPolygons)
{
	open({"demo:shell:16", "--normal", "z"});
	command("save-picture 320 200 " + path("small.png"));
	command("save-slice " + path("cut.vtp"));
	settle();
	EXPECT_EQ(sizeOfPng(path("small.png")), glm::ivec2(320, 200));
	EXPECT_TRUE(cli::contains(cli::contents(path("cut.vtp")), "<VTKFile type=\"PolyData\""));
	close();
}

TEST_F(WindowOfTheDesktop, FinishesItsFilesBeforeItCloses)
{
	open({"demo:shell:16", "--normal", "z"});
	for (const char* name : {"a.png", "b.png"})
		command("save-picture 320 200 " + path(name));
	command("save-slice " + path("cut.vtp"));
	close();
	for (const char* name : {"a.png", "b.png"})
		EXPECT_EQ(sizeOfPng(path(name)), glm::ivec2(320, 200)) << name;
	EXPECT_TRUE(cli::contents(path("cut.vtp")).ends_with("</VTKFile>\n"));
}

TEST_F(WindowOfTheDesktop, AFileThatFailsAsItClosesDecidesTheExitCode)
{
	open({"demo:shell:16", "--normal", "z"});
	command("save-slice /dev/null/cut.vtp");
	command("save-picture 320 200 " + path("a.png"));
	command("quit");
	EXPECT_EQ(program().waitFor(kPatience), 4);
	EXPECT_TRUE(cli::contains(err(), "/dev/null/cut.vtp: cannot be written")) << err();
	EXPECT_EQ(sizeOfPng(path("a.png")), glm::ivec2(320, 200));
}

TEST_F(WindowOfTheDesktop, FinishesItsFilesWhenItIsAskedToEnd)
{
	open({"demo:shell:16", "--normal", "z"});
	command("save-slice " + path("cut.vtp"));
	state(); // so the line before it was heard
	program().interrupt(SIGTERM);
	EXPECT_EQ(program().waitFor(kPatience), 143);
	EXPECT_EQ(err(), "");
	EXPECT_TRUE(cli::contents(path("cut.vtp")).ends_with("</VTKFile>\n"));
}

TEST_F(WindowOfTheDesktop, ClosesWhenTheDesktopWishesSo)
{
	open({"demo:shell:16"});
	press("alt+F4");
	EXPECT_EQ(program().waitFor(kPatience), 0);
	EXPECT_EQ(err(), "");
	EXPECT_TRUE(cli::contains(cli::contents(path("stats.json")), "\"validation_messages\": 0"));
}

TEST_F(WindowOfTheDesktop, ClosesByItsKeys)
{
	open({"demo:shell:16"});
	press("ctrl+q");
	EXPECT_EQ(program().waitFor(kPatience), 0);
	EXPECT_EQ(err(), "");
}

TEST_F(WindowOfTheDesktop, ACrashLeavesWhatWasSet)
{
	open({"demo:shell:16", "--normal", "z"});
	act("turn_x_plus");
	settle();
	const auto kept = [&]
	{
		for (const auto& entry : std::filesystem::recursive_directory_iterator(path("state")))
			if (entry.path().filename().string().starts_with("recovery-"))
				return cli::contents(entry.path());
		return std::string();
	};
	const std::string turned = settle()["probe"]["normal"];
	EXPECT_TRUE(eventually([&] { return cli::contains(kept(), turned); })) << kept();
	program().interrupt(SIGKILL);
	EXPECT_TRUE(program().waitFor(kPatience));
	EXPECT_TRUE(cli::contains(kept(), turned));
	// A state like any other.
	const std::string file = write("left.json", kept());
	EXPECT_EQ(run({"slice", "--state", file, "--classify", "cpu", "--stats", "-"}).status, 0);
}

TEST_F(WindowOfTheDesktop, ClosedItLeavesNothingToRecover)
{
	open({"demo:shell:16", "--normal", "z"});
	act("turn_x_plus");
	settle();
	close();
	for (const auto& entry : std::filesystem::recursive_directory_iterator(path("state")))
		EXPECT_TRUE(entry.is_directory()) << entry.path();
	EXPECT_TRUE(std::filesystem::exists(path("config") + "/volume-probes/view.json"));
}

TEST_F(WindowOfTheDesktop, CommandsThatFailAreToldAndTheOthersFollow)
{
	open({"demo:shell:16"});
	for (const char* line : {"do nothing", "jump", "size wide high", "save-state", "# only a remark", ""})
		command(line);
	command("save-state /dev/null/state.json");
	settle();
	const std::string said = err();
	EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 5) << said;
	for (const char* part : {"do nothing: ", "jump: ", "size wide high: ", "save-state: ", "/dev/null/state.json"})
		EXPECT_TRUE(cli::contains(said, part)) << part << " in\n" << said;
	close(said);
}

} // namespace view
