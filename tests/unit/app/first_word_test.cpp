#include "options/first_word.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace vp::test
{

namespace
{

using Words = std::vector<std::string>;

const Words kCommands{"info", "slice", "render", "sweep", "view", "convert"};

// Runs in a folder of its own, with or without a display.
class FirstWord : public testing::Test
{
protected:
	void SetUp() override
	{
		std::filesystem::create_directories(folder_);
		std::filesystem::current_path(folder_);
		showDisplay(false);
	}
	void TearDown() override
	{
		std::filesystem::current_path(before_);
		std::filesystem::remove_all(folder_);
	}
	static void showDisplay(bool is_there)
	{
		unsetenv("WAYLAND_DISPLAY");
		if (is_there)
			setenv("DISPLAY", ":7", 1);
		else
			unsetenv("DISPLAY");
	}
	static Words words(const Words& given) { return app::withCommand(given, kCommands, true).value(); }
	static std::string refused(const Words& given)
	{
		const auto result = app::withCommand(given, kCommands, true);
		return result ? "" : result.error().message;
	}

private:
	std::filesystem::path before_ = std::filesystem::current_path();
	std::filesystem::path folder_ =
	    std::filesystem::path(testing::TempDir()) / ("first-word-" + std::to_string(getpid()));
};

} // namespace

TEST_F(FirstWord, CommandsAndOptionsStay)
{
	for (const Words& given : {Words{}, Words{"--version"}, Words{"slice", "a.vtu"}})
		EXPECT_EQ(words(given), given);
}

TEST_F(FirstWord, AnInputIsViewedOrDrawn)
{
	EXPECT_EQ(words({"data/a.b.vtu", "--mesh"}), (Words{"render", "data/a.b.vtu", "--mesh"}));
	EXPECT_EQ(words({"demo:shell:8"}), (Words{"render", "demo:shell:8"}));
	showDisplay(true);
	EXPECT_EQ(words({"a.vtu", "--mesh"}), (Words{"view", "a.vtu", "--mesh"}));
}

TEST_F(FirstWord, AMistypedCommandGetsTheNearestName)
{
	EXPECT_EQ(refused({"slcie", "a.vtu"}), "slcie: no such command; slice is one");
	EXPECT_EQ(refused({"rendr"}), "rendr: no such command; render is one");
	EXPECT_EQ(refused({"xyzzy"}), "xyzzy: no such command");
	std::ofstream("data") << "a file without an ending";
	EXPECT_EQ(words({"data"}), (Words{"render", "data"}));
	EXPECT_FALSE(app::withCommand({"a.vtu"}, kCommands, false)); // as in vprobe-mpi
}

} // namespace vp::test
