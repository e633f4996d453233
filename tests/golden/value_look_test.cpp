#include "synthetic_scene.h"

#include "classify/gpu_records.h"
#include "render/scene/value_style.h"
#include "shared/slice_types.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace vp::render::test
{

namespace
{

constexpr std::uint32_t kPictureWidth = 200;
constexpr std::uint32_t kPictureHeight = 120;
using Pixel = std::array<std::uint8_t, 4>;

int brightness(const Pixel& p)
{
	return p[0] + p[1] + p[2];
}

} // namespace

class ValueLook : public DrawingTest
{
protected:
	ValueLook() : scene_(bareScene(kPictureWidth, kPictureHeight, 4))
	{
		scene_.look.colors = makeColorMap("grey").value();
	}

	void show(const std::function<double(double, double)>& f, int n = 8)
	{
		scene_.sheets = {square(kFacing, 1.5, 1.0, f, n)};
	}
	// The pixel at a point of the sheet.
	glm::dvec2 place(double u, double v) const
	{
		return scene_.camera.project({u, v, 0.0}, {double(kPictureWidth), double(kPictureHeight), {}, {}, {}});
	}
	Pixel at(const Picture& picture, double u, double v) const
	{
		const glm::dvec2 p = place(u, v);
		return picture.pixel(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y));
	}
	Picture without(int Look::*option)
	{
		Scene scene = scene_;
		scene.look.*option = 0;
		return draw(scene);
	}

	Scene scene_;
};

TEST_F(ValueLook, LinesLieAtTheirLevelsAndNowhereElse)
{
	// 0.2 to 0.8 along u: levels at 0.3, 0.4 … 0.7 within 0..1.
	show([](double u, double) { return 0.5 + 0.2 * u; });
	scene_.look.lines = 9;
	const Picture lines = draw(scene_);
	const Picture plain = without(&Look::lines);
	for (const double level : {0.3, 0.4, 0.5, 0.6, 0.7})
	{
		const double u = (level - 0.5) / 0.2;
		for (const double v : {-1.2, -0.1, 0.6})
		{
			const int change = brightness(at(lines, u, v)) - brightness(at(plain, u, v));
			EXPECT_TRUE(level < 0.33 ? change >= 60 : change <= -60) << level; // light on dark, dark on light
			EXPECT_EQ(at(lines, u + 0.25, v), at(plain, u + 0.25, v)) << level;
		}
	}
}

TEST_F(ValueLook, LinesAreEquallyWideWhereverTheyGo)
{
	// The ink along a row across one line, wherever values rise slowly or fast, along or across the pixels' rows.
	const auto inkAcross = [&](double slope, double turn)
	{
		scene_.look.range = {-5.0, 5.0}; // one level: 0
		const auto f = [=](double u, double v) { return slope * (std::cos(turn) * u + std::sin(turn) * v); };
		show(f, 1);
		scene_.look.lines = 1;
		const Picture lines = draw(scene_);
		const Picture plain = without(&Look::lines);
		double ink = 0.0;
		for (std::uint32_t x = 0; x < kPictureWidth; ++x)
			for (std::uint32_t y = 0; y < kPictureHeight; ++y)
				ink += brightness(plain.pixel(x, y)) - brightness(lines.pixel(x, y));
		// Over the length of the line within the square.
		const double bend = std::max(std::abs(std::cos(turn)), std::abs(std::sin(turn)));
		return ink * bend;
	};
	scene_.look.lines = 1;
	const double wide = inkAcross(0.2, 0.0);
	EXPECT_GT(wide, 1000.0);
	for (const double slope : {0.05, 0.5, 2.0})
		for (const double turn : {0.0, 0.5, 1.5707963, 2.4})
			EXPECT_NEAR(inkAcross(slope, turn), wide, 0.12 * wide) << slope << " " << turn;
}

TEST_F(ValueLook, LinesStayOffNanAndPlateaus)
{
	const auto f = [](double u, double v)
	{
		if (u < -0.2)
			return std::numeric_limits<double>::quiet_NaN();
		return v > 0.3 ? 0.5 : 0.5 + 0.4 * u; // a plateau at a level
	};
	show(f, 10);
	scene_.look.lines = 9;
	const Picture lines = draw(scene_);
	const Picture plain = without(&Look::lines);
	for (double v = -1.4; v < 1.4; v += 0.05)
		for (double u = -1.4; u < 1.4; u += 0.05)
		{
			// Polygons that touch NaN end at u = 0.
			if (u < -0.05 || (u > 0.05 && v > 0.7))
			{
				ASSERT_EQ(at(lines, u, v), at(plain, u, v)) << u << " " << v;
			}
		}
	EXPECT_LE(brightness(at(lines, 0.5, -0.9)), brightness(at(plain, 0.5, -0.9)) - 60);
}

TEST_F(ValueLook, InfinityIsBeyondTheRange)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	scene_.values = ValueScale{"f", 0.0, 1.0};
	scene_.values->below = scene_.values->above = true;
	scene_.look.colors = makeColorMap("viridis").value();
	scene_.look.lines = 5;
	scene_.look.labels = false;
	// Corners lie at multiples of 0.375.
	show([](double u, double) { return u < -0.5 ? -kInfinity : u > 0.5 ? kInfinity : 0.5 + u; }, 8);
	const Picture plain = draw(scene_);
	scene_.look.marks_out_of_range = true;
	const Picture picture = draw(scene_);
	for (const double v : {-1.2, 0.1, 0.9})
	{
		EXPECT_LE(difference(rgb(scene_.look.colors.at(0.0)), at(plain, -1.0, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.at(1.0)), at(plain, 1.0, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.below), at(picture, -1.0, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.above), at(picture, 1.0, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.nan), at(picture, -0.55, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.nan), at(picture, 0.55, v)), 1.0);
		EXPECT_LE(difference(rgb(scene_.look.colors.at(0.5)), at(picture, 0.0, v)), 6.0);
	}
}

TEST_F(ValueLook, LinesOfCellValuesGoBetweenCells)
{
	// Two halves, constant each, with a level between them; above v = 0.5 there is none between.
	scene_.values->per_cell = true;
	scene_.look.lines = 1;
	std::vector<vp::shared::PolygonRecord> records;
	const auto add = [&](float u0, float u1, float v0, float v1, float value)
	{
		vp::shared::PolygonRecord record{};
		record.vertices = 4;
		const float uv[] = {u0, v0, u1, v0, u1, v1, u0, v1};
		std::copy(std::begin(uv), std::end(uv), record.uv);
		std::fill(record.value, record.value + 4, value);
		records.push_back(record);
	};
	add(-1.0f, 0.0f, -1.0f, 0.5f, 0.3f);
	add(0.0f, 1.0f, -1.0f, 0.5f, 0.7f);
	add(-1.0f, 0.0f, 0.5f, 1.0f, 0.52f);
	add(0.0f, 1.0f, 0.5f, 1.0f, 0.7f);
	auto on_device = classify::recordsFromHost(classify::RecordPool::create(device()), records);
	ASSERT_TRUE(on_device);
	scene_.sheets = {{kFacing, *on_device, 1.0}};
	const Picture lines = draw(scene_);
	const Picture plain = without(&Look::lines);
	const auto ink = [&](double u, double v) { return brightness(at(plain, u, v)) - brightness(at(lines, u, v)); };
	for (double v = -0.9; v < 0.4; v += 0.1)
	{
		EXPECT_GE(std::max(ink(0.02, v), ink(-0.02, v)), 60) << v;
		EXPECT_EQ(ink(0.2, v), 0) << v;
		EXPECT_EQ(ink(-0.2, v), 0) << v;
	}
	EXPECT_GE(std::max(ink(-0.5, 0.48), ink(-0.5, 0.52)), 60);
	EXPECT_EQ(ink(0.5, 0.5), 0);
	EXPECT_EQ(std::max(ink(0.02, 0.8), ink(-0.02, 0.8)), 0);
}

TEST_F(ValueLook, BandsHaveOneColorEach)
{
	show([](double u, double) { return 0.5 + 0.32 * u; }, 1);
	scene_.look.colors = makeColorMap("viridis").value();
	scene_.look.bands = 4;
	scene_.look.samples = 1;
	const ValueStyle style = valueStyle(scene_.look, *scene_.values);
	ASSERT_EQ(style.bands, (std::vector<double>{0.2, 0.4, 0.6, 0.8}));
	const Picture picture = draw(scene_);
	std::set<Pixel> seen;
	for (std::uint32_t x = 60; x < 140; ++x)
		seen.insert(picture.pixel(x, kPictureHeight / 2));
	EXPECT_EQ(seen.size(), 5u);
	for (std::size_t band = 0; band < 5; ++band)
	{
		const double u = (0.1 + 0.2 * static_cast<double>(band) - 0.5) / 0.32;
		const Rgb color = rgb(scene_.look.colors.at(0.1 + 0.2 * static_cast<double>(band)));
		EXPECT_LE(difference(color, at(picture, u, 0.2)), 1.0) << band;
	}
}

TEST_F(ValueLook, ALogarithmicScale)
{
	show([](double u, double) { return u; }, 1); // -1.5 .. 1.5
	scene_.values = ValueScale{"f", -1.5, 1.5, false, false, 0.01};
	scene_.look.logarithmic = true;
	scene_.look.samples = 1;
	const Picture plain = draw(scene_);
	EXPECT_LE(difference(rgb(scene_.look.colors.at(0.0)), at(plain, -0.7, 0.0)), 1.0);
	scene_.look.marks_out_of_range = true;
	const Picture picture = draw(scene_);
	EXPECT_LE(difference(rgb(scene_.look.colors.below), at(picture, -0.7, 0.0)), 1.0);
	for (const double value : {0.1, 0.4, 1.3})
	{
		const glm::dvec2 p = place(value, 0.0);
		const auto found = hit(scene_, kFacing, 2.0, std::floor(p.x) + 0.5, 59.5);
		const double part = std::log(found->u / 0.01) / std::log(1.5 / 0.01);
		EXPECT_LE(difference(rgb(scene_.look.colors.at(part)), picture.pixel(static_cast<std::uint32_t>(p.x), 59)),
		          1.0);
	}
}

TEST_F(ValueLook, CategoriesHaveTheirColors)
{
	ColorMap& map = scene_.look.colors;
	map.categories = {{-1.0, "a", {200, 0, 0}}, {0.0, "b", {0, 200, 0}}, {5.0, "c", {0, 0, 200}}};
	const auto expectAt = [&](double value, Color color)
	{
		show([value](double, double) { return value; });
		EXPECT_LE(difference(rgb(color), at(draw(scene_), 0.1, 0.1)), 1.0) << value;
	};
	expectAt(-1.0, {200, 0, 0});
	expectAt(0.0, {0, 200, 0});
	expectAt(0.4, {0, 200, 0});
	expectAt(-0.6, {200, 0, 0});
	expectAt(5.0, {0, 0, 200});
	expectAt(2.0, map.nan);
	expectAt(-3.0, map.nan);
	expectAt(7.0, map.nan);
}

TEST_F(ValueLook, OpacityByValue)
{
	scene_.look.background = parseBackground("transparent").value();
	ColorMap& map = scene_.look.colors;
	for (int i = 0; i < kColorMapSize; ++i)
		map.colors[i].a = static_cast<std::uint8_t>(i);
	for (const double value : {0.0, 0.25, 0.8, 1.0})
	{
		show([value](double, double) { return value; });
		scene_.sheets[0].opacity = 0.5;
		EXPECT_NEAR(at(draw(scene_), 0.0, 0.0)[3], 0.5 * 255.0 * value, 1.0) << value;
	}
}

TEST_F(ValueLook, LitSheetsAreDarkerTheMoreTheyTurnAway)
{
	const auto white = [](double, double) { return 1.0; };
	const auto shade = [&](const Vec3& normal, bool lit)
	{
		scene_.look.lit = lit;
		scene_.sheets = {square(probe::makeSheet({0.0, 0.0, 0.0}, normal), 1.5, 1.0, white)};
		return draw(scene_).pixel(kPictureWidth / 2, kPictureHeight / 2)[0];
	};
	const Vec3 towards_light = glm::normalize(Vec3(-0.3, 0.45, 1.0));
	EXPECT_EQ(shade({1.0, 0.0, 0.7}, false), 255);
	EXPECT_EQ(shade(towards_light, true), 255);
	EXPECT_EQ(shade(-towards_light, true), 255); // no back
	EXPECT_LT(shade({0.0, 0.0, 1.0}, true), 250);
	EXPECT_LT(shade({1.0, 0.0, 0.3}, true), shade({0.0, 0.0, 1.0}, true) - 40);
	EXPECT_GE(shade({1.0, 0.0, 0.3}, true), 0.45 * 255.0 - 1.0);
}

} // namespace vp::render::test
