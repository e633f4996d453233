#include "desktop.h"

#include <gtest/gtest.h>

namespace view
{

namespace
{

vp::render::ColorMap viridis()
{
	return *vp::render::makeColorMap("viridis");
}

class Picture : public Desktop
{
};

} // namespace

TEST_F(Picture, AnInputAppearsInTheColoursOfTheMap)
{
	open({"demo:shell:32", "--normal", "0.3", "0.5", "0.8"});
	const Area left{100, 100, 500, 450};
	EXPECT_GT(shareOf(viridis(), rest(left)), 0.1);
	keepPicture("shell");
	const nlohmann::json stats = close();
	EXPECT_GE(stats["cut_ms"]["count"], 1) << stats.dump(1);
}

TEST_F(Picture, WithoutInputTheWindowWaitsForOne)
{
	open({});
	const Area left{100, 100, 500, 450};
	EXPECT_LT(shareOf(viridis(), rest(left)), 0.01);
	command("open demo:shell:16");
	settle();
	EXPECT_TRUE(eventually([&] { return shareOf(viridis(), seen(left)) > 0.1; }));
	close();
}

TEST_F(Picture, TheNextArrayIsShown)
{
	open({"demo:shell:16", "--normal", "z"});
	moveTo({500, 300});
	const nlohmann::json before = settle();
	const Area left{100, 100, 500, 450};
	const vp::render::Picture first = rest(left);
	press("a");
	const nlohmann::json after = settle();
	EXPECT_NE(before["probe"].value("array", ""), after["probe"].value("array", ""));
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) > 0.05; }));
	close();
}

} // namespace view
