#include "desktop.h"

#include <gtest/gtest.h>

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

} // namespace view
