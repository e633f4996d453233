#include "render/scene/levels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vp::render
{

TEST(Levels, AreRoundAndAboutAsManyAsAskedFor)
{
	EXPECT_EQ(roundLevels(0.0, 1.0, 3, false), (std::vector<double>{0.25, 0.5, 0.75}));
	EXPECT_EQ(roundLevels(0.0, 1.0, 9, false), (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9}));
	EXPECT_EQ(roundLevels(-1.2, 1.2, 1, false), (std::vector<double>{0.0}));
	EXPECT_EQ(roundLevels(1012.0, 1038.0, 5, false), (std::vector<double>{1015, 1020, 1025, 1030, 1035}));
	for (const auto& [lo, hi] : {std::pair{0.0, 1.0}, {-3.7, 12.9}, {1e-9, 3e-9}, {1e6, 1.00001e6}, {-8e20, 3e20}})
		for (int about = 1; about <= 100; ++about)
		{
			const std::vector<double> levels = roundLevels(lo, hi, about, false);
			ASSERT_FALSE(levels.empty());
			EXPECT_GE(levels.size(), std::max(1.0, 0.5 * about)) << lo << " " << hi << " " << about;
			EXPECT_LE(levels.size(), 1.55 * about + 1.0) << lo << " " << hi << " " << about;
			EXPECT_GT(levels.front(), lo);
			EXPECT_LT(levels.back(), hi);
			for (std::size_t i = 2; i < levels.size(); ++i)
			{
				const double step = levels[1] - levels[0];
				EXPECT_NEAR(levels[i] - levels[i - 1], step, 1e-6 * step);
				const double digits = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
				EXPECT_NEAR(std::min({std::abs(digits - 1), std::abs(digits - 2), std::abs(digits - 2.5),
				                      std::abs(digits - 5)}),
				            0.0, 1e-4);
			}
		}
}

TEST(Levels, OfALogarithmicScaleAreDecadesAndPartsOfThem)
{
	EXPECT_EQ(roundLevels(0.5, 2e4, 5, true), (std::vector<double>{1, 10, 100, 1000, 1e4}));
	EXPECT_EQ(roundLevels(0.9, 99.0, 6, true), (std::vector<double>{1, 2, 5, 10, 20, 50}));
	EXPECT_EQ(roundLevels(1e-30, 1e30, 6, true), (std::vector<double>{1e-20, 1e-10, 1.0, 1e10, 1e20}));
	// No power of ten within.
	EXPECT_EQ(roundLevels(21.0, 29.0, 3, true), (std::vector<double>{22.5, 25, 27.5}));
}

TEST(Levels, OfNothingThereAreNone)
{
	EXPECT_TRUE(roundLevels(0.0, 1.0, 0, false).empty());
	EXPECT_TRUE(roundLevels(2.0, 2.0, 5, false).empty());
	EXPECT_TRUE(roundLevels(1.0, 1.0 + 1e-9, 5, false).empty());
	EXPECT_TRUE(roundLevels(1.0, 1.0, 5, true).empty());
	EXPECT_LE(roundLevels(0.0, 1.0, 1'000'000, false).size(), 2u * kMaxLevels);
}

} // namespace vp::render
