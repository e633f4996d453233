#include "render/annotate/layout.h"

#include "render/annotate/contour_labels.h"
#include "render/annotate/overlay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::render
{

namespace
{

struct Size
{
	std::uint32_t width;
	std::uint32_t height;
};

constexpr Size kSizes[] = {{320, 240}, {640, 480}, {1280, 720}, {720, 1280}, {1920, 1080}, {3840, 2160}, {1000, 200}};

Scene sceneOf(Size size, const char* array, double lo, double hi, bool clipped)
{
	Scene scene;
	scene.look.width = size.width;
	scene.look.height = size.height;
	scene.look.title = "a data set";
	scene.look.caption = "origin (0, 0, 0)   normal (0, 0, 1)";
	if (clipped)
		scene.look.range = {lo, hi};
	scene.values = ValueScale{array, lo, hi, true};
	return scene;
}

const char* const kLongName = "turbulence_kinetic_energy_dissipation_rate of the second phase, averaged";

} // namespace

TEST(Layout, NothingOverlapsAtAnySize)
{
	for (const Size size : kSizes)
		for (const char* array : {"s", "v magnitude", kLongName})
			for (const bool clipped : {false, true})
			{
				const Scene scene = sceneOf(size, array, -1234.5, 98765.4e3, clipped);
				const Layout layout = makeLayout(scene);
				const Area free{layout.frame.free_lo, layout.frame.free_hi};
				ASSERT_EQ(layout.legends.size(), 1u);
				const LegendLayout& legend = layout.legends[0];
				const Area areas[] = {layout.title, layout.caption, layout.axes, legend.column};
				for (const Area& a : areas)
				{
					EXPECT_GE(a.lo.x, 0.0);
					EXPECT_GE(a.lo.y, 0.0);
					EXPECT_LE(a.hi.x, size.width);
					EXPECT_LE(a.hi.y, size.height);
					for (const Area& b : areas)
						EXPECT_TRUE(&a == &b || !a.overlaps(b)) << size.width << " " << &a - areas << " " << &b - areas;
				}
				for (const Area& a : {layout.title, layout.caption, legend.column})
					EXPECT_FALSE(a.overlaps(free)) << size.width << "x" << size.height << " " << array;
				EXPECT_GE(free.size().x, 0.45 * size.width) << size.width << "x" << size.height << " " << array;
				EXPECT_GE(free.size().y, 0.6 * size.height);
				EXPECT_GE(legend.bar.size().y, 0.25 * size.height);
			}
}

// From pictures with no room for a legend up to those that have it.
TEST(Layout, SmallPicturesHaveALegendThatFitsOrNone)
{
	std::size_t some = 0;
	std::size_t none = 0;
	for (std::uint32_t width = 40; width <= 320; width += 35)
		for (std::uint32_t height = 16; height <= 240; height += 8)
			for (const double hi : {1.0, 98765.4e3})
				for (const bool clipped : {false, true})
				{
					Scene scene = sceneOf({width, height}, "s", 0.0, hi, clipped);
					scene.values->has_nan = clipped;
					const Layout layout = makeLayout(scene);
					(layout.legends.empty() ? none : some) += 1;
					for (const LegendLayout& legend : layout.legends)
					{
						SCOPED_TRACE(testing::Message() << width << "x" << height << " up to " << hi);
						EXPECT_GE(legend.bar.size().y, 3.0 * layout.em);
						EXPECT_GE(legend.title.size().y, 1.2 * layout.em);
						EXPECT_GE(legend.title.lo.y, 0.5 * layout.margin);
						EXPECT_LE(legend.title.hi.y, legend.factor.lo.y + 1e-9);
						EXPECT_LE(legend.factor.hi.y, legend.bar.lo.y - legend.cap);
						EXPECT_LE(legend.column.hi.y, height);
						EXPECT_GE(legend.column.lo.x, 0.0);
						EXPECT_LE(legend.column.hi.x, width);
					}
				}
	EXPECT_GT(some, 100u);
	EXPECT_GT(none, 20u);
}

TEST(Layout, WithoutValuesThereAreNoNumbers)
{
	Scene scene = sceneOf({640, 480}, "s", 0.0, 0.0, false);
	ASSERT_EQ(makeLayout(scene).legends.size(), 1u);
	EXPECT_EQ(makeLayout(scene).legends[0].ticks.marks.size(), 1u); // a constant
	scene.values->empty = true;
	ASSERT_EQ(makeLayout(scene).legends.size(), 1u);
	EXPECT_TRUE(makeLayout(scene).legends[0].ticks.marks.empty());
	scene.look.range = {1.0, 2.0};
	EXPECT_FALSE(makeLayout(scene).legends[0].ticks.marks.empty());
}

TEST(Layout, CategoriesFitOrAreToldInANumber)
{
	for (const Size size : kSizes)
		for (const int count : {1, 3, 20, 400})
		{
			Scene scene = sceneOf(size, "s", 0.0, 1.0, false);
			for (int i = 0; i < count; ++i)
				scene.look.colors.categories.push_back({double(i), i == 1 ? kLongName : "name", {10, 20, 30}});
			const Layout layout = makeLayout(scene);
			ASSERT_EQ(layout.legends.size(), 1u);
			const LegendLayout& legend = layout.legends[0];
			EXPECT_GE(legend.categories, 1u);
			EXPECT_LE(legend.categories, static_cast<std::size_t>(count));
			const double lines = static_cast<double>(legend.categories) + (legend.categories < size_t(count) ? 1 : 0);
			EXPECT_LE(legend.bar.lo.y + lines * legend.entry, legend.bar.hi.y + 1.0);
			EXPECT_LE(legend.column.hi.y, size.height);
			EXPECT_LE(legend.column.size().x, 0.3 * size.width + 1.0);
			const Overlay overlay = makeOverlay(scene);
			for (const std::uint32_t i : overlay.indices)
				EXPECT_LE(overlay.vertices.at(i).pos.x, size.width);
		}
}

// A pointed end says that there are values beyond it.
TEST(Layout, EndsArePointedWhereValuesLieBeyond)
{
	const auto endsOf =
	    [](std::optional<std::pair<double, double>> range, std::optional<std::pair<double, double>> reach)
	{
		Scene scene = sceneOf({640, 480}, "s", -1.0, 2.0, false);
		scene.look.range = range;
		scene.values->reach = reach;
		const ValueStyle style = legendContents(scene).front().style;
		return std::pair(style.below, style.above);
	};
	EXPECT_EQ(endsOf({}, std::pair(-1.0, 2.0)), std::pair(false, false));
	EXPECT_EQ(endsOf({}, std::pair(-1.0, 3.0)), std::pair(false, true)); // a window of a scan
	EXPECT_EQ(endsOf(std::pair(0.0, 5.0), std::pair(-1.0, 2.0)), std::pair(true, false));
	EXPECT_EQ(endsOf(std::pair(-1.0, 2.0), std::pair(-1.0, 2.0)), std::pair(false, false));
	EXPECT_EQ(endsOf(std::pair(0.0, 5.0), {}), std::pair(true, true));
}

// The labels of a legend are a line apart, and the ends have theirs.
TEST(Layout, LegendsNameTheirEnds)
{
	for (const Size size : kSizes)
		for (const double hi : {1.2345, 98765.4e3})
			for (const int lines : {0, 12})
			{
				Scene scene = sceneOf(size, "s", 0.1234 * hi, hi, false);
				scene.look.lines = lines;
				const Layout layout = makeLayout(scene);
				ASSERT_EQ(layout.legends.size(), 1u);
				const ValueStyle style = legendContents(scene).front().style;
				const auto& marks = layout.legends[0].ticks.marks;
				ASSERT_GE(marks.size(), 2u);
				EXPECT_EQ(marks.front().value, style.lo);
				EXPECT_EQ(marks.back().value, style.hi);
				for (std::size_t i = 1; i < marks.size(); ++i)
					EXPECT_GE((style.part(marks[i].value) - style.part(marks[i - 1].value)) *
					              layout.legends[0].bar.size().y,
					          layout.em)
					    << size.width << "x" << size.height;
			}
}

TEST(Layout, TextHasTheSizeThatIsAskedFor)
{
	Scene scene = sceneOf({640, 480}, "s", 0.0, 1.0, false);
	scene.look.text_size = 12.0; // 9 points
	const Layout layout = makeLayout(scene);
	EXPECT_NEAR(layout.em, 12.0 * 2384.0 / 2048.0, 1e-9); // the em of DejaVu Sans is 2048 of its units
	EXPECT_NEAR(layout.title_em / layout.em, 1.3, 1e-9);
	EXPECT_EQ(*parseTextSize("9pt"), 12.0);
	EXPECT_EQ(*parseTextSize("14"), 14.0);
	EXPECT_EQ(*parseTextSize("14px"), 14.0);
	for (const char* wrong : {"", "pt", "9mm", "1", "1000", "-3", "12 pt"})
		EXPECT_FALSE(parseTextSize(wrong)) << wrong;
}

TEST(Layout, SheetsOfOtherLooksHaveLegendsOfTheirOwn)
{
	for (const Size size : kSizes)
	{
		Scene scene = sceneOf(size, "s", 0.0, 1.0, false);
		scene.sheets.resize(6);
		EXPECT_EQ(legendContents(scene).size(), 1u);
		scene.sheets[1].values = ValueScale{"v magnitude", -3.0, 1e7, true};
		scene.sheets[2].values = scene.sheets[1].values;
		scene.sheets[3].colors = makeColorMap("turbo").value();
		scene.sheets[4].lines = 7;
		scene.sheets[5].range = {0.2, 0.4};
		const auto contents = legendContents(scene);
		ASSERT_EQ(contents.size(), 4u);
		EXPECT_EQ(contents[0].title, "s");
		EXPECT_EQ(contents[1].title, "v magnitude");
		EXPECT_EQ(contents[2].title, "s (sheet 4)");
		EXPECT_EQ(contents[3].title, "s (sheet 6)");
		EXPECT_TRUE(contents[3].style.below && contents[3].style.above);

		const Layout layout = makeLayout(scene);
		ASSERT_GE(layout.legends.size(), 1u);
		EXPECT_TRUE(layout.legends.size() >= 3 || size.height < 40 * layout.em);
		for (const LegendLayout& a : layout.legends)
		{
			EXPECT_GE(a.bar.size().y, 3.0 * layout.em) << size.width << "x" << size.height;
			EXPECT_GE(a.column.lo.y, 0.0);
			EXPECT_LE(a.column.hi.y, size.height);
			EXPECT_LE(a.column.hi.x, size.width);
			for (const LegendLayout& b : layout.legends)
				EXPECT_TRUE(&a == &b || !a.column.overlaps(b.column)) << size.width << "x" << size.height;
		}
		// If every sheet has its own legend, the scene's is not shown.
		scene.sheets.resize(2);
		scene.sheets[0].colors = makeColorMap("grey").value();
		EXPECT_EQ(legendContents(scene).size(), 2u);
		EXPECT_EQ(legendContents(scene)[0].style.colors->name, "grey");
	}
}

TEST(Layout, WhatIsOffLeavesItsPlace)
{
	Scene scene = sceneOf({640, 480}, "s", 0.0, 1.0, false);
	const Frame with = pictureFrame(scene);
	scene.look.legend = false;
	scene.look.title.clear();
	scene.look.caption.clear();
	scene.look.axes = false;
	const Frame without = pictureFrame(scene);
	EXPECT_LT(with.free_hi.x, without.free_hi.x);
	EXPECT_GT(with.free_lo.y, without.free_lo.y);
	EXPECT_LT(with.free_hi.y, without.free_hi.y);
	EXPECT_TRUE(with.corner);
	EXPECT_FALSE(without.corner);
	EXPECT_EQ(makeOverlay(scene).indices.size(), 0u);
}

TEST(ContourLabels, HaveTheGroundThatIsSeen)
{
	const Background white{{255, 255, 255}, {255, 255, 255}};
	const Color dark{40, 20, 60};
	const Color opaque = labelGround(dark, 1.0, white);
	EXPECT_EQ(opaque, (Color{40, 20, 60, opaque.a}));
	EXPECT_GT(opaque.a, 220);
	// Half of a dark sheet is light before white, and words on it are dark.
	const Color half = labelGround(dark, 0.5, white);
	EXPECT_NEAR(half.r, 148, 1);
	EXPECT_NEAR(half.g, 138, 1);
	EXPECT_NEAR(half.b, 158, 1);
	EXPECT_LT(half.a, 128);
	EXPECT_LT(luminance(inkOver(half)), luminance(half));
	EXPECT_GT(luminance(inkOver(opaque)), luminance(opaque));
	EXPECT_GT(labelGround(dark, 0.0, white).a, 60);
	EXPECT_EQ(labelGround(dark, 0.5, parseBackground("transparent").value()), half);
}

TEST(Overlay, StaysInsideThePicture)
{
	for (const Size size : kSizes)
		for (const char* array : {"s", kLongName})
		{
			Scene scene = sceneOf(size, array, -1.0, 1e-4, true);
			scene.look.box_axes = true;
			scene.bounds = Box{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
			scene.camera.position = {12.0, 8.0, 16.0};
			scene.look.title = kLongName;
			scene.look.title += kLongName;
			const Overlay overlay = makeOverlay(scene);
			EXPECT_FALSE(overlay.indices.empty());
			for (const std::uint32_t i : overlay.indices)
			{
				const ImVec2 p = overlay.vertices.at(i).pos;
				EXPECT_TRUE(p.x >= 0.0f && p.y >= 0.0f && p.x <= size.width && p.y <= size.height)
				    << p.x << " " << p.y << " in " << size.width << "x" << size.height;
			}
		}
}

TEST(FontAtlas, ElidesAndWraps)
{
	const FontAtlas lettering({16.0}, {kLongName, "ρ"});
	const double most = 100.0;
	EXPECT_EQ(lettering.elided("s", 16.0, most), "s");
	const std::string elided = lettering.elided(kLongName, 16.0, most);
	EXPECT_LE(lettering.width(elided, 16.0), most);
	EXPECT_TRUE(elided.ends_with("…"));
	const auto lines = lettering.wrapped(kLongName, 16.0, most, 3);
	ASSERT_EQ(lines.size(), 3u);
	EXPECT_EQ(lines[0], "turbulence_");
	for (const std::string& line : lines)
		EXPECT_LE(lettering.width(line, 16.0), most);
	EXPECT_EQ(lettering.wrapped("density ρ", 16.0, most, 3), std::vector<std::string>{"density ρ"});
	EXPECT_EQ(lettering.wrapped("density ρ", 16.0, 1.0, 2).size(), 2u); // no room for a letter, and no endless loop
}

} // namespace vp::render
