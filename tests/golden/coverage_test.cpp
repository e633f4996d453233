#include "synthetic_scene.h"

#include <algorithm>
#include <cmath>

namespace vp::render::test
{

class Coverage : public DrawingTest
{
};

TEST_F(Coverage, AnEmptyPictureIsItsBackground)
{
	Scene scene = bareScene(33, 40, 4);
	scene.look.background = parseBackground("transparent").value();
	Picture picture = draw(scene);
	EXPECT_EQ(picture.rgba, std::vector<std::uint8_t>(picture.rgba.size(), 0));

	scene.look.background = parseBackground("#204060").value();
	picture = draw(scene);
	for (std::uint32_t y = 0; y < picture.height; ++y)
		EXPECT_EQ(picture.pixel(7, y), (std::array<std::uint8_t, 4>{0x20, 0x40, 0x60, 255}));

	scene.look.background = {{200, 100, 0}, {0, 100, 200}};
	picture = draw(scene);
	for (std::uint32_t y = 0; y < picture.height; ++y)
	{
		const double down = (y + 0.5) / picture.height;
		EXPECT_LE(difference({200.0 * (1.0 - down), 100.0, 200.0 * down}, picture.pixel(20, y)), 1.0);
	}
}

TEST_F(Coverage, EdgesHaveAsManyShadesAsSamples)
{
	for (const int samples : {1, 4, 5, 8, 16})
		for (const double edge : {40.0, 40.13, 40.5, 40.77})
		{
			// The sheet fills the picture left of x = edge.
			Scene scene = bareScene(80, 60, samples);
			scene.look.background = parseBackground("transparent").value();
			const double pixel = 2.0 * 5.0 * std::tan(20.0 * std::acos(-1.0) / 180.0) / 60.0;
			const double half_side = 8.0;
			const probe::Sheet sheet = probe::makeSheet({pixel * (edge - 40.0) - half_side, 0.0, 0.0}, {0.0, 0.0, 1.0});
			scene.sheets.push_back(square(sheet, half_side, 1.0, half, 5));
			const Picture picture = draw(scene);
			for (std::uint32_t x = 36; x < 44; ++x)
			{
				const double covered = 255.0 * std::clamp(edge - x, 0.0, 1.0);
				const auto seen = picture.pixel(x, 30);
				EXPECT_NEAR(seen[3], covered, 255.0 / samples * 0.5 + 1.5) << samples << " " << edge << " " << x;
				// A pixel that is half covered keeps its color.
				if (seen[3] > 60)
				{
					EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), seen), 3.0);
				}
			}
		}
}

TEST_F(Coverage, OpacityIsThePixelsAlpha)
{
	Scene scene = bareScene(64, 48, 8);
	scene.look.background = parseBackground("transparent").value();
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 1.0, 0.4, half));
	const auto pixel = draw(scene).pixel(32, 24);
	EXPECT_NEAR(pixel[3], 102, 1);
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), pixel), 2.0);
}

TEST_F(Coverage, LinesHideBehindSheetsAndShowThroughThem)
{
	Scene scene = bareScene(120, 96, 8);
	const std::vector<Segment> lines{{{-2.0, 0.5, -0.4}, {2.0, 0.5, -0.4}}, {{-2.0, -0.5, 0.4}, {2.0, -0.5, 0.4}}};
	scene.outline = lines;
	const probe::Sheet sheet = probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
	scene.sheets.push_back(square(sheet, 1.0, 1.0, half));
	const Frame frame{120.0, 96.0, {}, {}, {}};
	// The darkest pixel over the line's height at x: lines are thinner than two pixels.
	const auto darkest = [&](const Picture& picture, double x, double y, double z)
	{
		const glm::dvec2 place = scene.camera.project({x, y, z}, frame);
		std::array<std::uint8_t, 4> found{255, 255, 255, 255};
		for (int dy = -2; dy <= 2; ++dy)
		{
			const auto pixel =
			    picture.pixel(static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y + dy));
			if (pixel[0] + pixel[1] + pixel[2] < found[0] + found[1] + found[2])
				found = pixel;
		}
		return found;
	};
	const Rgb color = rgb(scene.look.colors.at(0.5));

	Picture picture = draw(scene);
	EXPECT_LE(difference(color, darkest(picture, 0.0, 0.5, -0.4)), 1.0) << "behind an opaque sheet";
	EXPECT_GE(difference(color, darkest(picture, 0.0, -0.5, 0.4)), 25.0) << "before it";
	EXPECT_GE(difference(kWhite, darkest(picture, 1.3, 0.5, -0.4)), 120.0) << "beside it";

	scene.sheets[0].opacity = 0.5;
	picture = draw(scene);
	const double behind = difference(over(color, 0.5, kWhite), darkest(picture, 0.0, 0.5, -0.4));
	EXPECT_GE(behind, 40.0) << "behind a translucent sheet";
	EXPECT_LE(behind, 0.55 * difference(kWhite, darkest(picture, 1.3, 0.5, -0.4)));

	// Dark gray at 88 percent over white; a full pixel of it lies under a line of constant width wherever it goes.
	scene.sheets.clear();
	picture = draw(scene);
	EXPECT_EQ(darkest(picture, 0.0, 0.5, -0.4), darkest(picture, 1.3, 0.5, -0.4));
}

TEST_F(Coverage, LinesPastTheEyeDoNotTurnInsideOut)
{
	Scene scene = bareScene(80, 60, 2);
	// From before the camera to behind it, and one all behind.
	const std::vector<Segment> lines{{{0.0, -0.5, 0.0}, {0.0, -0.5, 40.0}}, {{-1.0, 1.0, 9.0}, {1.0, 1.0, 9.0}}};
	scene.outline = lines;
	const Picture picture = draw(scene);
	std::size_t above = 0;
	std::size_t below = 0;
	for (std::uint32_t y = 0; y < picture.height; ++y)
		for (std::uint32_t x = 0; x < picture.width; ++x)
			if (picture.pixel(x, y)[0] < 250)
				(y < 30 ? above : below) += 1;
	EXPECT_EQ(above, 0u);
	EXPECT_GE(below, 10u);
}

TEST_F(Coverage, ASheetSeenEdgeOnIsNothing)
{
	Scene scene = bareScene(80, 60, 4);
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), 1.0, 1.0, half));
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, -0.5}, {0.0, 0.0, 1.0}), 1.0, 1.0, half));
	const Picture picture = draw(scene);
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), picture.pixel(40, 30)), 1.0);
}

TEST_F(Coverage, SizesChangeFromPictureToPicture)
{
	for (const auto& [width, height, sheets] : {std::tuple{64u, 48u, 1}, {100u, 30u, 3}, {64u, 48u, 2}, {1u, 1u, 0}})
	{
		Scene scene = bareScene(width, height, 2);
		for (int i = 0; i < sheets; ++i)
			scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.1 * i}, {0.0, 0.0, 1.0}), 1.0, 1.0, half));
		const Picture picture = draw(scene);
		EXPECT_EQ(picture.rgba.size(), std::size_t(4) * width * height);
		if (sheets > 0)
		{
			EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), picture.pixel(width / 2, height / 2)), 1.0);
		}
	}
}

} // namespace vp::render::test
