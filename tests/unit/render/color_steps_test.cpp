#include "render/scene/color_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vp::render
{

namespace
{

ValueStyle styleFor(const ColorMap& map, double lo, double hi, bool logarithmic = false)
{
	ValueStyle style;
	style.colors = &map;
	style.lo = lo;
	style.hi = hi;
	style.logarithmic = logarithmic;
	return style;
}

const ColorMap kMap = makeColorMap("viridis").value();

} // namespace

TEST(ColorSteps, FollowTheColorMap)
{
	const ValueStyle style = styleFor(kMap, -2.0, 6.0);
	for (const int count : {64, 256})
	{
		const ColorSteps steps = colorSteps(style, count);
		ASSERT_EQ(steps.colors.size(), static_cast<std::size_t>(count));
		ASSERT_EQ(steps.bounds.size() + 1, steps.colors.size());
		EXPECT_TRUE(std::is_sorted(steps.bounds.begin(), steps.bounds.end()));
		for (double value = -2.0; value <= 6.0; value += 0.037)
		{
			const Color shown = steps.colors[steps.at(value)];
			const Color exact = kMap.at((value + 2.0) / 8.0);
			EXPECT_NEAR(shown.g, exact.g, 256.0 / count + 1.0);
			EXPECT_NEAR(shown.r, exact.r, 512.0 / count + 1.0);
		}
	}
	EXPECT_TRUE(colorSteps(style, 64).opaque());
}

TEST(ColorSteps, OfALogarithmicScaleAreEqualFactors)
{
	const ColorSteps steps = colorSteps(styleFor(kMap, 1.0, 1e4, true), 4);
	ASSERT_EQ(steps.bounds.size(), 3u);
	for (int i = 0; i < 3; ++i)
		EXPECT_NEAR(steps.bounds[i], std::pow(10.0, i + 1), 1e-9 * std::pow(10.0, i + 1));
}

TEST(ColorSteps, BeyondTheRangeThereAreOthers)
{
	ValueStyle style = styleFor(kMap, 0.0, 1.0);
	style.below = style.above = true;
	const ColorSteps plain = colorSteps(style, 8);
	EXPECT_EQ(plain.colors[plain.at(-1e-12)], kMap.at(0.0));
	EXPECT_EQ(plain.colors[plain.at(1.0 + 1e-12)], kMap.at(1.0));
	ValueStyle banded = style;
	banded.bands = {0.5};
	EXPECT_EQ(colorSteps(banded, 8).colors.front(), kMap.at(0.25));
	EXPECT_EQ(colorSteps(banded, 8).colors.back(), kMap.at(0.75));
	style.marks = true;
	const ColorSteps steps = colorSteps(style, 8);
	EXPECT_EQ(steps.colors[steps.at(-1e-12)], kMap.below);
	EXPECT_EQ(steps.colors[steps.at(0.0)], kMap.at(0.5 / 8));
	EXPECT_EQ(steps.colors[steps.at(1.0)], kMap.at(7.5 / 8));
	EXPECT_EQ(steps.colors[steps.at(1.0 + 1e-12)], kMap.above);
}

TEST(ColorSteps, BandsCategoriesAndConstants)
{
	ValueStyle style = styleFor(kMap, 0.0, 1.0);
	style.bands = {0.25, 0.5};
	const ColorSteps bands = colorSteps(style, 256);
	EXPECT_EQ(bands.bounds, style.bands);
	EXPECT_EQ(bands.colors[bands.at(0.5)], style.bandColor(2));

	ColorMap names = kMap;
	names.categories = {{2.0, "two", {1, 2, 3}}, {5.0, "five", {4, 5, 6}}};
	const ColorSteps categories = colorSteps(styleFor(names, 0.0, 9.0), 256);
	EXPECT_EQ(categories.colors[categories.at(2.0)], (Color{1, 2, 3}));
	EXPECT_EQ(categories.colors[categories.at(5.4)], (Color{4, 5, 6}));
	EXPECT_EQ(categories.colors[categories.at(3.5)], names.nan);

	const ColorSteps constant = colorSteps(styleFor(kMap, 3.0, 3.0), 256);
	EXPECT_TRUE(constant.bounds.empty());
	EXPECT_EQ(constant.colors, std::vector{kMap.at(0.5)});
}

} // namespace vp::render
