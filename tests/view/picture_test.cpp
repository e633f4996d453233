#include "desktop.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace view
{

namespace
{

vp::render::ColorMap viridis()
{
	return *vp::render::makeColorMap("viridis");
}

// Lit or in shade, as nothing else in the window is.
double shareOfMagenta(const vp::render::Picture& picture)
{
	std::size_t count = 0;
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
		{
			const auto [r, g, b, a] = picture.pixel(x, y);
			count += r > 90 && b > 90 && g < 40;
		}
	return static_cast<double>(count) / (picture.width * picture.height);
}

class Picture : public Desktop
{
};

} // namespace

TEST_F(Picture, AnInputAppearsInTheColorsOfTheMap)
{
	open({"demo:shell:32", "--normal", "0.3", "0.5", "0.8"});
	const Area left{100, 100, 500, 450};
	EXPECT_GT(shareOf(viridis(), rest(left)), 0.1);
	const nlohmann::json stats = close();
	EXPECT_GE(stats["cut_ms"]["count"], 1) << stats.dump(1);
}

// The first picture is there before cells know their neighbors. Moved and put back, the sheet looks as it did.
TEST_F(Picture, NeighborsComeUnseen)
{
	open({"demo:tets:24", "--normal", "0.3", "0.5", "0.8"});
	const Area left{100, 100, 500, 450};
	const vp::render::Picture first = rest(left);
	EXPECT_GT(shareOf(viridis(), first), 0.1);
	act("push_forward");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) > 0.01; }));
	act("undo");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) < 0.001; }));
	act("mesh"); // lines of the cut's polygons: the same, whichever way they were found
	settle();
	act("mesh");
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) < 0.001; }));
	close();
}

TEST_F(Picture, WithoutInputTheWindowWaitsForOne)
{
	open({});
	const Area left{100, 100, 500, 450};
	EXPECT_LT(shareOf(viridis(), rest(left)), 0.05); // the small pictures of the start page
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

TEST_F(Picture, WhatIsLaunchedFollowsTheProbe)
{
	open({"demo:shell:32", "--normal", "z", "--vectors", "tufts", "--vector-color", "#ff00ff"});
	moveTo({5, 640});
	const nlohmann::json state = settle();
	EXPECT_EQ(state["vectors"]["vectors"], "tufts");
	const Area left{100, 100, 500, 450};
	const vp::render::Picture first = rest(left);
	EXPECT_GT(shareOfMagenta(first), 0.002);
	act("push_forward");
	settle();
	EXPECT_TRUE(eventually(
	    [&]
	    {
		    const vp::render::Picture now = seen(left);
		    return difference(first, now) > 0.01 && shareOfMagenta(now) > 0.002;
	    }));
	act("undo");
	settle();
	EXPECT_TRUE(eventually([&] { return difference(first, seen(left)) == 0.0; }));
	close();
}

// docs/VIEWER.md has them by the same names; keep_pictures.sh copies them there.
TEST_F(Picture, TheManualsAreTaken)
{
	open({"demo:shell:64", "--normal", "0.3", "0.5", "0.8", "--size", "1100x720"});
	moveTo({5, 640});
	const auto take = [&](const std::string& name)
	{
		settle();
		keepWindow(name);
		EXPECT_EQ(cli::sizeOf(cli::contents(VPROBE_VIEW_OUTPUT "/" + name + ".png")), (cli::PictureSize{1100, 720}));
	};
	take("shell");
	act("preset_trihedral");
	act("lines");
	take("trihedral");
	act("preset_single");
	act("lines");
	act("plane_pane");
	take("plane");
	close();
}

TEST_F(Picture, TheValueUnderThePointerIsTold)
{
	open({"demo:shell:32", "--normal", "z"});
	const Area line{8, 672, 400, 26}; // the status line's beginning
	moveTo({5, 640});
	settle();
	const vp::render::Picture beside = rest(line);
	moveTo({480, 280});
	EXPECT_TRUE(eventually([&] { return difference(beside, seen(line)) > 0.02; }));
	const vp::render::Picture on_sheet = rest(line);
	moveTo({200, 300});
	EXPECT_TRUE(eventually([&] { return difference(on_sheet, seen(line)) > 0.005; }));
	close();
}

TEST_F(Picture, AContourFollowsThePointer)
{
	open({"demo:shell:32", "--normal", "z", "--camera", "40,35", "--window", "3", "3"});
	const Area left{100, 130, 500, 470}; // what is written gets a ground once the camera is no longer fitted
	moveTo({5, 640});
	const vp::render::Picture sheet = rest(left);
	act("contour");
	settle();
	EXPECT_LT(difference(sheet, rest(left)), 0.001); // the pointer is on no sheet
	moveTo({400, 330});
	EXPECT_TRUE(eventually([&] { return difference(sheet, seen(left)) > 0.01; }));
	const vp::render::Picture one = rest(left);
	moveTo({335, 470});
	EXPECT_TRUE(eventually([&] { return difference(one, seen(left)) > 0.01; }));
	keepPicture("contour");
	act("contour");
	moveTo({5, 640});
	EXPECT_TRUE(eventually([&] { return difference(sheet, seen(left)) < 0.005; }));
	close();
}

} // namespace view
