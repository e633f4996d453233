#include "profile/steps.h"

#include <gtest/gtest.h>

#include <random>

namespace vp::app
{

// By hand: of 12 values the last six are larger. There are 12! / (6! 6!) = 924 ways to choose six, so about 2 in 924
// are parted as clearly in the middle, and hardly any more elsewhere.
TEST(Steps, OneStepByHand)
{
	const std::vector<Step> steps = stepsOf({10, 11, 9, 10, 12, 10, 20, 22, 19, 21, 20, 20});
	ASSERT_EQ(steps.size(), 1u);
	EXPECT_EQ(steps[0].at, 6u);
	EXPECT_DOUBLE_EQ(steps[0].ratio, 2.0); // medians 10 and 20
	EXPECT_LE(steps[0].probability, 0.01);
	EXPECT_GE(steps[0].probability, 0.001); // the series itself is one in 1000
}

TEST(Steps, TwoStepsAndBack)
{
	std::vector<double> values;
	std::mt19937 random(3);
	std::uniform_real_distribution<double> noise(0.97, 1.03);
	for (const double level : {1.0, 1.2, 1.0})
		for (int k = 0; k < 12; ++k)
			values.push_back(level * noise(random));
	values[5] = 9.0; // a run that something disturbed
	const std::vector<Step> steps = stepsOf(values);
	ASSERT_EQ(steps.size(), 2u);
	EXPECT_EQ(steps[0].at, 12u);
	EXPECT_EQ(steps[1].at, 24u);
	EXPECT_NEAR(steps[0].ratio, 1.2, 0.04);
	EXPECT_NEAR(steps[1].ratio, 1.0 / 1.2, 0.04);
}

TEST(Steps, NoStepInNoiseOrInLittle)
{
	EXPECT_TRUE(stepsOf({}).empty());
	EXPECT_TRUE(stepsOf({1, 1, 1, 2, 2, 2, 2}).empty());
	EXPECT_TRUE(stepsOf(std::vector<double>(30, 5.0)).empty());
	std::mt19937 random(4);
	std::normal_distribution<double> noise(10.0, 1.0);
	int wrong = 0;
	for (int series = 0; series < 100; ++series)
	{
		std::vector<double> values;
		for (int k = 0; k < 20; ++k)
			values.push_back(noise(random));
		wrong += !stepsOf(values).empty();
	}
	EXPECT_LE(wrong, 5); // 1 is expected
}

} // namespace vp::app
