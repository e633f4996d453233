#include "desktop.h"

#include <gtest/gtest.h>

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

TEST_F(WindowOfTheDesktop, ComesBackAsItWasAfterMinimising)
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
	const std::string good = write(
	    "good.vtk", "# vtk DataFile Version 3.0\none\nASCII\nDATASET STRUCTURED_POINTS\n"
	                "DIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 27\n"
	                "SCALARS heat float 1\nLOOKUP_TABLE default\n" +
	                    []
	                    {
		                    std::string values;
		                    for (int i = 0; i < 27; ++i)
			                    values += std::to_string(i % 7) + "\n";
		                    return values;
	                    }());
	command("drop " + good);
	const nlohmann::json state = settle();
	ASSERT_EQ(state["input"]["files"].size(), 1u) << state.dump(1);
	EXPECT_TRUE(cli::contains(state["input"]["files"][0], "good.vtk"));
	EXPECT_TRUE(eventually([&] { return shareOf(map_, seen(left_)) > 0.1; }));
	close();
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

TEST_F(WindowOfTheDesktop, CommandsThatFailAreToldAndTheOthersFollow)
{
	open({"demo:shell:16"});
	for (const char* line : {"do nothing", "jump", "size wide high", "save-state", "# only a remark", ""})
		command(line);
	command("save-state /nonexistent/state.json");
	settle();
	const std::string said = err();
	EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 5) << said;
	for (const char* part : {"do nothing: ", "jump: ", "size wide high: ", "save-state: ", "/nonexistent/state.json"})
		EXPECT_TRUE(cli::contains(said, part)) << part << " in\n" << said;
	close(said);
}

} // namespace view
