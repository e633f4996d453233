#include "synthetic_scene.h"

#include "shared/render_types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::render::test
{

namespace
{

constexpr double kHalf = 1.4;
// Returns the sheets that a ray meets, nearest first.
std::vector<std::pair<double, std::size_t>> order(const Scene& scene, double x, double y)
{
	std::vector<std::pair<double, std::size_t>> hits;
	for (std::size_t i = 0; i < scene.sheets.size(); ++i)
		if (const auto found = hit(scene, scene.sheets[i].sheet, kHalf, x, y))
			hits.push_back({found->distance, i});
	std::sort(hits.begin(), hits.end());
	return hits;
}

using Value = std::function<double(double, double)>;

// Compares each pixel with the blend of the sheets in the order of their distances. Pixels with an edge or a crossing
// of two sheets within `reach` pixels are left out.
struct Comparison
{
	std::size_t compared = 0;
	std::size_t several = 0; // compared pixels with more than one sheet
	double worst = 0.0;
};

Comparison compare(const Scene& scene, const Picture& picture, const Value& f)
{
	Comparison result;
	const double reach = 1.0;
	const auto indices = [&](double x, double y)
	{
		std::vector<std::size_t> list;
		for (const auto& [distance, i] : order(scene, x, y))
			list.push_back(i);
		return list;
	};
	for (std::uint32_t y = 0; y < picture.height; y += 3)
		for (std::uint32_t x = 0; x < picture.width; x += 3)
		{
			const auto here = indices(x + 0.5, y + 0.5);
			bool alike = true;
			for (const double dy : {-reach, reach})
				for (const double dx : {-reach, reach})
					alike = alike && indices(x + 0.5 + dx, y + 0.5 + dy) == here;
			if (!alike)
				continue;
			Rgb expected = kWhite;
			for (auto i = here.rbegin(); i != here.rend(); ++i)
			{
				const SheetDrawing& sheet = scene.sheets[*i];
				const auto found = hit(scene, sheet.sheet, kHalf, x + 0.5, y + 0.5);
				expected = over(rgb(scene.look.colors.at(f(found->u, found->v))), sheet.opacity, expected);
			}
			++result.compared;
			result.several += here.size() > 1;
			result.worst = std::max(result.worst, difference(expected, picture.pixel(x, y)));
		}
	return result;
}

double ramp(double u, double v)
{
	return 0.5 + 0.25 * u + 0.1 * v;
}

} // namespace

class Blending : public DrawingTest
{
};

TEST_F(Blending, OneSheetShowsItsValues)
{
	for (const std::string& map : colorMapNames())
	{
		Scene scene = bareScene(200, 160, 1);
		scene.look.colors = makeColorMap(map).value();
		scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.4, 0.3, 1.0}), kHalf, 1.0, ramp));
		const Comparison result = compare(scene, draw(scene), ramp);
		EXPECT_LE(result.worst, 2.0) << map;
		EXPECT_GE(result.compared, 2000u);
	}
}

TEST_F(Blending, TwoCrossingSheetsAreInOrderAtEveryPixel)
{
	for (const int samples : {1, 8})
	{
		Scene scene = bareScene(240, 200, samples);
		scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.7, 0.1, 1.0}), kHalf, 0.6, ramp));
		scene.sheets.push_back(square(probe::makeSheet({0.1, 0.0, 0.1}, {-0.7, 0.4, 0.8}), kHalf, 0.5, ramp));
		const Comparison result = compare(scene, draw(scene), ramp);
		EXPECT_LE(result.worst, 2.0);
		EXPECT_GE(result.several, 800u);
	}
}

TEST_F(Blending, ThreeCrossingSheetsAreInOrderAtEveryPixel)
{
	Scene scene = bareScene(240, 200, 1);
	scene.camera.position = {3.0, 2.0, 4.0};
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), kHalf, 0.7, ramp));
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), kHalf, 0.6, ramp));
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), kHalf, 0.5, ramp));
	const Comparison result = compare(scene, draw(scene), ramp);
	EXPECT_LE(result.worst, 2.0);
	EXPECT_GE(result.several, 1000u);
}

TEST_F(Blending, AsManySheetsAsThereAreLayers)
{
	Scene scene = bareScene(160, 120, 1);
	// Not in the order of their depths.
	for (std::size_t i = 0; i < shared::kMaxLayers; ++i)
	{
		const double z = 0.1 * static_cast<double>(i * 7 % shared::kMaxLayers) - 0.8;
		scene.sheets.push_back(square(probe::makeSheet({0.3 * z, 0.0, z}, {0.05 * z, 0.1, 1.0}), kHalf, 0.2, ramp));
	}
	const Comparison result = compare(scene, draw(scene), ramp);
	EXPECT_LE(result.worst, 2.0);
	EXPECT_GE(result.several, 500u);

	scene.sheets.push_back(scene.sheets.front());
	const auto refused = renderer().draw(scene);
	ASSERT_FALSE(refused);
	EXPECT_EQ(refused.error().kind, ErrorKind::usage);
}

TEST_F(Blending, AFarAwaySceneIsDrawnAsExactly)
{
	Scene scene = bareScene(200, 160, 4);
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.7, 0.1, 1.0}), kHalf, 0.6, ramp));
	scene.sheets.push_back(square(probe::makeSheet({0.1, 0.0, 0.1}, {-0.7, 0.4, 0.8}), kHalf, 0.5, ramp));
	std::vector<Segment> outline{{{-1.0, -1.0, 0.5}, {1.0, 1.0, -0.5}}};
	scene.outline = outline;
	const Picture near = draw(scene);
	const Vec3 away(1e7, -2e7, 3e6);
	for (SheetDrawing& sheet : scene.sheets)
		sheet.sheet.origin += away;
	scene.camera.position += away;
	scene.camera.focal_point += away;
	outline[0].a += away;
	outline[0].b += away;
	const Picture far = draw(scene);
	std::size_t different = 0;
	for (std::size_t i = 0; i < near.rgba.size(); ++i)
		different += std::abs(int(near.rgba[i]) - int(far.rgba[i])) > 2;
	EXPECT_LE(different, near.rgba.size() / 1000);
}

// Software colors several pixels at a time, round by round, as long as one of them has a layer left. A line behind a
// sheet does not depend on whether the pixels beside have another sheet behind it.
TEST_F(Blending, ALineIsDrawnOnceWhateverIsBeside)
{
	Scene scene = bareScene(200, 160, 1);
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.5}, {0.0, 0.0, 1.0}), kHalf, 0.6, ramp));
	std::vector<Segment> outline;
	for (double at = -1.0; at <= 1.0; at += 0.05)
		outline.push_back({{-1.0, at, -0.2}, {1.0, at + 0.1, -0.2}});
	scene.outline = outline;
	const Picture alone = draw(scene);
	const probe::Sheet behind = probe::makeSheet({1.2, 0.3, -1.0}, {0.1, 0.2, 1.0});
	scene.sheets.push_back(square(behind, kHalf, 0.6, ramp));
	const Picture together = draw(scene);
	std::size_t compared = 0;
	std::size_t hidden = 0; // where the other sheet is behind
	for (std::uint32_t y = 0; y < alone.height; ++y)
		for (std::uint32_t x = 0; x < alone.width; ++x)
		{
			if (hit(scene, behind, kHalf, x + 0.5, y + 0.5))
			{
				++hidden;
				continue;
			}
			const auto pixel = alone.pixel(x, y);
			EXPECT_LE(difference({double(pixel[0]), double(pixel[1]), double(pixel[2])}, together.pixel(x, y)), 1.0)
			    << x << ", " << y;
			++compared;
		}
	EXPECT_GE(std::min(compared, hidden), 8000u);
}

TEST_F(Blending, AConstantHasTheMiddleOfTheMap)
{
	Scene scene = bareScene(64, 64, 1);
	scene.values = ValueScale{"f", 3.0, 3.0, false};
	scene.sheets.push_back(
	    square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), kHalf, 1.0, [](double, double) { return 3.0; }));
	EXPECT_LE(difference(rgb(scene.look.colors.at(0.5)), draw(scene).pixel(32, 32)), 1.0);
}

TEST_F(Blending, ColorsOutsideTheRange)
{
	Scene scene = bareScene(90, 60, 1);
	scene.look.range = {0.0, 1.0};
	// Along u, at the polygons' corners: NaN, NaN, below, within and above the range.
	const auto f = [](double u, double)
	{
		if (u < -0.69)
			return std::numeric_limits<double>::quiet_NaN();
		return u < 0.01 ? -1.0 : u < 0.71 ? 0.5 : 2.0;
	};
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), kHalf, 1.0, f, 4));
	Picture picture = draw(scene);
	const auto at = [&](double u)
	{
		const glm::dvec2 place = scene.camera.project({u, 0.1, 0.0}, {90.0, 60.0, {}, {}, {}});
		return picture.pixel(static_cast<std::uint32_t>(place.x), static_cast<std::uint32_t>(place.y));
	};
	const ColorMap& map = scene.look.colors;
	EXPECT_LE(difference(rgb(map.nan), at(-1.2)), 1.0);
	EXPECT_LE(difference(rgb(map.at(0.0)), at(0.15)), 1.0);
	EXPECT_LE(difference(rgb(map.at(1.0)), at(1.3)), 1.0);
	scene.look.bands = 4; // 0.2, 0.4, 0.6 and 0.8 are between them
	picture = draw(scene);
	EXPECT_LE(difference(rgb(map.at(0.1)), at(0.15)), 1.0);
	EXPECT_LE(difference(rgb(map.at(0.9)), at(1.3)), 1.0);
	scene.look.bands = 0;
	scene.look.marks_out_of_range = true;
	picture = draw(scene);
	EXPECT_LE(difference(rgb(map.nan), at(-1.2)), 1.0);
	EXPECT_LE(difference(rgb(map.nan), at(-0.1)), 1.0); // a polygon with a NaN has no value anywhere
	EXPECT_LE(difference(rgb(map.below), at(0.15)), 1.0);
	EXPECT_LE(difference(rgb(map.above), at(1.3)), 1.0);

	// Without a range of the user's, whatever there is lies within it.
	scene.look.range.reset();
	const Picture within = draw(scene);
	for (std::size_t i = 0; i < within.rgba.size(); i += 4)
		for (const Color outside : {map.below, map.above})
			EXPECT_FALSE(within.rgba[i] == outside.r && within.rgba[i + 1] == outside.g &&
			             within.rgba[i + 2] == outside.b);
}

TEST_F(Blending, SheetsWithoutAnArrayArePlain)
{
	Scene scene = bareScene(64, 64, 1);
	scene.values.reset();
	scene.sheets.push_back(square(probe::makeSheet({0.0, 0.0, 0.0}, {0.0, 0.2, 1.0}), kHalf, 1.0, ramp));
	const Picture picture = draw(scene);
	EXPECT_EQ(picture.pixel(32, 32), picture.pixel(24, 40));
	EXPECT_NE(picture.pixel(32, 32), picture.pixel(1, 1));
}

} // namespace vp::render::test
