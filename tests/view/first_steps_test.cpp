#include "desktop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace view
{

namespace
{

// The window of somebody who has never opened one.
class FirstSteps : public Desktop
{
protected:
	void SetUp() override
	{
		Desktop::SetUp();
		std::filesystem::remove_all(path("config") + "/volume-probes");
	}
	nlohmann::json settings() const
	{
		return nlohmann::json::parse(cli::contents(path("config") + "/volume-probes/view.json"));
	}
	void click(const glm::ivec2& at) const
	{
		moveTo(at);
		xdotool("click 1\n");
	}
};

constexpr Area kHint{250, 32, 350, 42}; // about the text of the hint, in the upper middle of the scene

// Pixels of its most frequent color, as a share.
double evenness(const vp::render::Picture& picture)
{
	std::map<std::array<std::uint8_t, 4>, int> counts;
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
			++counts[picture.pixel(x, y)];
	int most = 0;
	for (const auto& [color, count] : counts)
		most = std::max(most, count);
	return static_cast<double>(most) / (picture.width * picture.height);
}

} // namespace

TEST_F(FirstSteps, TheStartPageOffersBuiltInDataSets)
{
	open({});
	// The cards stand in three columns about the middle of the scene, which the panels leave.
	constexpr glm::ivec2 middle{(kWidth - 290) / 2, kHeight / 2 + 60};
	constexpr Area card{middle.x - 50, middle.y - 60, 100, 120};
	EXPECT_TRUE(eventually([&] { return evenness(seen(card)) < 0.9; })) << "no picture on the card";
	// One card a frame gets its picture. The last card is the first one of the third line, once the page has its
	// height.
	constexpr Area last{middle.x - 200, middle.y + 62, 110, 96};
	int looks = 0;
	const auto staysDrawn = [&] { return (looks = evenness(seen(last)) < 0.9 ? looks + 1 : 0) >= 10; };
	EXPECT_TRUE(eventually(staysDrawn)) << "no picture on the last card";
	moveTo(middle);
	keepWindow("start");
	click(middle);
	EXPECT_TRUE(eventually([&] { return !state()["input"]["files"].empty(); }));
	const nlohmann::json opened = settle();
	EXPECT_TRUE(opened["input"]["files"][0].get<std::string>().starts_with("demo:")) << opened;
	close();
	EXPECT_EQ(settings()["recent"][0], opened["input"]["files"][0]);
}

TEST_F(FirstSteps, HintsCanBeReadAndSentAway)
{
	open({"demo:blob:8"});
	keepWindow("hint");
	const vp::render::Picture first = rest(kHint);
	act("hints"); // off
	settle();
	EXPECT_TRUE(eventually([&] { return difference(seen(kHint), first) > 0.2; }));
	act("hints"); // and on again
	settle();
	EXPECT_TRUE(eventually([&] { return difference(seen(kHint), first) < 0.01; }));
	act("hints");
	close();
	EXPECT_EQ(settings()["hints"], false);
}

// Once the sheet was dragged, the hint about it is over.
TEST_F(FirstSteps, HintsGoOnWhenTheStepIsDone)
{
	open({"demo:blob:8", "--normal", "z"});
	const vp::render::Picture first = rest(kHint);
	act("turn_x_plus"); // not what the hint says
	settle();
	EXPECT_LT(difference(rest(kHint), first), 0.01);
	drag({180, 420}, {180, 380}); // the sheet, beside the handles
	settle();
	EXPECT_TRUE(eventually([&] { return difference(seen(kHint), first) > 0.2; }));
	close();
}

TEST_F(FirstSteps, ACommandIsFoundByItsName)
{
	open({"demo:blob:8"});
	searchFor("right angles");
	keepWindow("find_command");
	press("Return");
	EXPECT_TRUE(eventually([&] { return state()["probe"]["probe"] == "trihedral"; })) << state();
	// Escape leaves without doing anything.
	searchFor("quit");
	press("Escape");
	EXPECT_EQ(settle()["probe"]["probe"], "trihedral");
	close();
}

TEST_F(FirstSteps, TextGrowsAndStaysSo)
{
	open({"demo:blob:8"});
	const Area menu{0, 0, 400, 20};
	const vp::render::Picture before = rest(menu);
	press("ctrl+equal");
	press("ctrl+equal");
	EXPECT_TRUE(eventually([&] { return difference(seen(menu), before) > 0.05; }));
	press("ctrl+minus");
	settle();
	close();
	EXPECT_NEAR(settings()["text_size"].get<double>(), 1.1, 1e-9);
}

} // namespace view
