#include "desktop.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace view
{

namespace
{

class SweepInTheWindow : public Desktop
{
protected:
	const Area left_{100, 100, 500, 450};
};

} // namespace

TEST_F(SweepInTheWindow, PlaysAndKeepsThePoseWhenItPauses)
{
	open({"demo:shell:16", "--normal", "z", "--path", "translate", "--frames", "200"});
	act("panels");
	moveTo({5, 690});
	const nlohmann::json before = settle();
	const vp::render::Picture first = rest(left_);
	press("space");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left_)) > 0.02; }));
	const vp::render::Picture second = seen(left_);
	EXPECT_TRUE(eventually([&] { return difference(second, seen(left_)) > 0.02; }));
	press("space");
	const nlohmann::json after = settle();
	EXPECT_NE(before["probe"], after["probe"]);
	const vp::render::Picture paused = rest(left_);
	EXPECT_EQ(settle(), after);
	EXPECT_EQ(difference(paused, rest(left_)), 0.0);
	close();
}

TEST_F(SweepInTheWindow, IsRecordedIntoAFilmLoopAndSaved)
{
	open({"demo:shell:16", "--normal", "z", "--path", "translate", "--frames", "6"});
	act("record");
	const nlohmann::json before = settle();
	command("save-film " + path("frame{frame:02}.png"));
	EXPECT_EQ(settle(), before);
	std::set<std::string> pictures;
	for (int k = 0; k < 6; ++k)
		pictures.insert(cli::contents(path("frame0" + std::to_string(k) + ".png")));
	EXPECT_EQ(pictures.size(), 6u) << "every frame shows another cut";
	EXPECT_FALSE(pictures.contains(""));
	close();
}

TEST_F(SweepInTheWindow, WithoutAFilmLoopThereIsNoFilmToSave)
{
	open({"demo:shell:16"});
	command("save-film " + path("film{frame}.png"));
	settle();
	EXPECT_TRUE(cli::contains(err(), "Record the sweep first"));
	close(err());
}

} // namespace view
