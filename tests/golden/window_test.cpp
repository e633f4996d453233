#include "synthetic_scene.h"

#include "render/passes/picture_geometry.h"

#include <cmath>

namespace vp::render::test
{

namespace
{

double paleWaves(double u, double v)
{
	return 0.5 + 0.3 * std::sin(4.0 * u) * std::cos(3.0 * v);
}

using Pixel = std::array<std::uint8_t, 4>;

} // namespace

class Windows : public DrawingTest
{
protected:
	// Seen at an angle, nothing behind it.
	Scene slanted()
	{
		Scene scene = bareScene(200, 160, 1);
		scene.look.background = parseBackground("transparent").value();
		scene.camera.position = {1.5, 1.0, 4.5};
		scene.sheets.push_back(square(probe::makeSheet({0.1, 0.0, 0.0}, {0.2, -0.3, 1.0}), 1.4, 1.0, paleWaves, 17));
		return scene;
	}
};

TEST_F(Windows, InsideThePixelsAreThoseOfTheWholeSheetAndOutsideThereAreNone)
{
	for (const WindowRect& window : {WindowRect{-0.5, 0.7, -0.9, 0.31}, WindowRect{-9.0, 9.0, 0.123, 0.456},
	                                 WindowRect{0.2, 0.21, -1.0, 1.0}, WindowRect{-9.0, 9.0, -9.0, 9.0}})
		for (const int samples : {1, 4})
		{
			Scene scene = slanted();
			scene.look.samples = samples;
			const Picture whole = draw(scene);
			scene.sheets[0].window = window;
			scene.sheets[0].rim = false;
			const Picture clipped = draw(scene);
			std::size_t inside = 0;
			std::size_t outside = 0;
			for (std::uint32_t y = 0; y < 160; ++y)
				for (std::uint32_t x = 0; x < 200; ++x)
				{
					// A pixel's square, and a bit more, is all inside, all outside, or neither.
					bool all_in = true;
					bool all_out = true;
					for (const double dy : {-0.51, 0.51})
						for (const double dx : {-0.51, 0.51})
						{
							const auto at = hit(scene, scene.sheets[0].sheet, 1e9, x + 0.5 + dx, y + 0.5 + dy).value();
							const bool in =
							    at.u >= window.x0 && at.u <= window.x1 && at.v >= window.y0 && at.v <= window.y1;
							all_in = all_in && in;
							all_out = all_out && !in;
						}
					if (all_in)
					{
						inside += whole.pixel(x, y)[3] != 0;
						// At an edge there are all samples, elsewhere one.
						const auto whole_pixel = whole.pixel(x, y);
						ASSERT_LE(difference({double(whole_pixel[0]), double(whole_pixel[1]), double(whole_pixel[2])},
						                     clipped.pixel(x, y)),
						          samples == 1 ? 0.0 : 2.0)
						    << x << " " << y;
						ASSERT_EQ(clipped.pixel(x, y)[3], whole_pixel[3]) << x << " " << y;
					}
					// All corners of a strip that is narrower than a pixel may be outside.
					else if (all_out && window.x1 - window.x0 > 0.1)
					{
						++outside;
						ASSERT_EQ(clipped.pixel(x, y), Pixel{}) << x << " " << y;
					}
				}
			EXPECT_TRUE(inside > 1000 || window.x1 - window.x0 < 0.1);
			EXPECT_TRUE(outside > 1000 || window.y1 >= 1.0);
		}
}

TEST_F(Windows, MagnificationDrawsTheSameThingLarger)
{
	// 1.6 times the uv of a sheet, or a sheet 1.6 times as large: the same picture.
	Scene scene = slanted();
	const probe::Sheet sheet = scene.sheets[0].sheet;
	const auto stretched = [](double u, double v) { return paleWaves(u / 1.6, v / 1.6); };
	scene.sheets[0] = square(sheet, 1.6 * 1.4, 1.0, stretched, 17);
	scene.sheets[0].window = WindowRect{-1.6 * 0.5, 1.6 * 0.8, -1.6 * 0.2, 1.6 * 0.6};
	const Picture large = draw(scene);
	scene.sheets[0] = square(sheet, 1.4, 1.0, paleWaves, 17);
	scene.sheets[0].window = WindowRect{-0.5, 0.8, -0.2, 0.6};
	scene.sheets[0].magnification = 1.6;
	const Picture magnified = draw(scene);
	std::size_t off = 0;
	std::size_t seen = 0;
	for (std::size_t i = 0; i < large.rgba.size(); ++i)
	{
		off += std::abs(int(large.rgba[i]) - int(magnified.rgba[i])) > 2;
		seen += large.rgba[i] != 0;
	}
	EXPECT_GE(seen, 20'000u);
	EXPECT_LE(off, 20u);
}

TEST_F(Windows, ARimIsDrawnAroundTheWindow)
{
	Scene scene = slanted();
	scene.look.background = parseBackground("white").value();
	scene.look.samples = 4;
	scene.sheets[0].window = WindowRect{-0.5, 0.6, -0.4, 0.7};
	scene.sheets[0].magnification = 1.2;
	const Picture with = draw(scene);
	scene.sheets[0].rim = false;
	const Picture without = draw(scene);
	std::vector<Segment> rim = windowRim(scene.sheets[0]);
	ASSERT_EQ(rim.size(), 4u);
	const Frame frame{200.0, 160.0, {}, {}, {}};
	const auto line = [&](const Segment& s, double part)
	{ return scene.camera.project(s.a + part * (s.b - s.a), frame); };
	for (const Segment& side : rim)
		for (const double part : {0.0, 0.3, 0.5, 1.0})
		{
			const glm::dvec2 at = line(side, part);
			const auto x = static_cast<std::uint32_t>(at.x);
			const auto y = static_cast<std::uint32_t>(at.y);
			const Pixel before = without.pixel(x, y);
			EXPECT_GE(difference({double(before[0]), double(before[1]), double(before[2])}, with.pixel(x, y)), 30.0);
		}
	// Nothing else changed: what differs lies near a side. An edge gives samples to two pixels on each side of it.
	for (std::uint32_t y = 0; y < 160; ++y)
		for (std::uint32_t x = 0; x < 200; ++x)
			if (with.pixel(x, y) != without.pixel(x, y))
			{
				double nearest = 1e9;
				for (const Segment& side : rim)
					for (int i = 0; i <= 400; ++i)
						nearest = std::min(nearest, glm::length(line(side, i / 400.0) - glm::dvec2(x + 0.5, y + 0.5)));
				ASSERT_LE(nearest, 3.5) << x << " " << y;
			}
	scene.sheets[0].window.reset();
	EXPECT_TRUE(windowRim(scene.sheets[0]).empty());
}

TEST_F(Windows, SheetsMayHaveALookOfTheirOwn)
{
	const auto plain = [](double, double) { return 0.4; };
	Scene scene = bareScene(120, 60, 1);
	scene.sheets.push_back(square(probe::makeSheet({-0.8, 0.0, 0.0}, {0.0, 0.0, 1.0}), 0.6, 1.0, plain));
	scene.sheets.push_back(square(probe::makeSheet({0.8, 0.0, 0.0}, {0.0, 0.0, 1.0}), 0.6, 1.0, plain));
	const Frame frame{120.0, 60.0, {}, {}, {}};
	const auto at = [&](const Picture& picture, double x)
	{
		const glm::dvec2 p = scene.camera.project({x, 0.0, 0.0}, frame);
		return picture.pixel(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y));
	};
	const ColorMap turbo = makeColorMap("turbo").value();
	const double value = 0.4;
	scene.sheets[1].colors = turbo;
	scene.sheets[1].range = {0.3, 1.3};
	Picture picture = draw(scene);
	EXPECT_LE(difference(rgb(scene.look.colors.at(value)), at(picture, -0.8)), 2.0);
	EXPECT_LE(difference(rgb(turbo.at(value - 0.3)), at(picture, 0.8)), 3.0);

	// An array of its own, and the look's range is not for that.
	scene.look.range = {-10.0, 10.0};
	scene.sheets[1].range.reset();
	scene.sheets[1].values = ValueScale{"g", -0.5, 1.5, false};
	picture = draw(scene);
	EXPECT_LE(difference(rgb(turbo.at(0.25 + 0.5 * value)), at(picture, 0.8)), 3.0);

	// Plain beside colored.
	scene.values.reset();
	picture = draw(scene);
	EXPECT_LE(difference(rgb(turbo.at(0.25 + 0.5 * value)), at(picture, 0.8)), 3.0);
	EXPECT_EQ(at(picture, -0.8), at(picture, -0.5));
}

} // namespace vp::render::test
