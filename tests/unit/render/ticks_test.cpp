#include "render/annotate/ticks.h"
#include "render/scene/levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace vp::render
{

namespace
{

std::vector<std::string> labels(const Ticks& ticks)
{
	std::vector<std::string> result;
	for (const Tick& tick : ticks.marks)
		result.push_back(tick.label);
	return result;
}

using Words = std::vector<std::string>;

} // namespace

TEST(Ticks, AreRound)
{
	EXPECT_EQ(labels(makeTicks(0.0, 1.0, 6)), (Words{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
	EXPECT_EQ(labels(makeTicks(-1.7, 2.3, 6)), (Words{"\u22121", "0", "1", "2"}));
	EXPECT_EQ(labels(makeTicks(0.0, 100.0, 5)), (Words{"0", "50", "100"}));
	EXPECT_EQ(labels(makeTicks(12.5, 17.5, 6)), (Words{"13", "14", "15", "16", "17"}));
	EXPECT_EQ(labels(makeTicks(1.0, 0.0, 3)), (Words{"0.0", "0.5", "1.0"}));
}

TEST(Ticks, AtGivenValues)
{
	EXPECT_EQ(labels(ticksAt({0.25, 0.5, 0.75}, 9, false)), (Words{"0.25", "0.50", "0.75"}));
	EXPECT_EQ(labels(ticksAt({1015, 1020, 1025}, 9, false)), (Words{"1015", "1020", "1025"}));
	EXPECT_EQ(labels(ticksAt({-1, 0, 1, 2, 3}, 3, false)), (Words{"0", "2"}));
	EXPECT_EQ(labels(ticksAt({1, 2, 5, 10, 20, 50, 100}, 3, true)), (Words{"1", "10", "100"}));
	const Ticks tiny = ticksAt({2.5e-9, 5e-9, 7.5e-9}, 9, false);
	EXPECT_EQ(labels(tiny), (Words{"2.5", "5.0", "7.5"}));
	EXPECT_EQ(tiny.factor, "×10⁻⁹");
	EXPECT_EQ(labels(ticksAt({3.25}, 9, false)), (Words{"3.25"}));
	EXPECT_TRUE(ticksAt({}, 9, false).marks.empty());
}

// Values that lie close together need more digits than four.
TEST(Ticks, NumbersAreToldApart)
{
	const auto told = [](const std::vector<double>& values)
	{
		Words words;
		for (const double value : values)
			words.push_back(shortNumber(value, digitsApart(values)));
		return words;
	};
	EXPECT_EQ(told({101325.0, 101325.5, 101326.0}), (Words{"101325", "101325.5", "101326"}));
	EXPECT_EQ(told({100000.02, 100000.04}), (Words{"100000.02", "100000.04"}));
	EXPECT_EQ(told({-2.0002e-7, -2.0001e-7}), (Words{"\u22122.0002×10⁻⁷", "\u22122.0001×10⁻⁷"}));
	EXPECT_EQ(told({101328.0}), (Words{"101328"}));
	EXPECT_EQ(told({-1.0, 0.0, 1.0}), (Words{"\u22121", "0", "1"}));
	EXPECT_EQ(digitsApart({0.1, 0.2, 0.3}), 4);
	EXPECT_EQ(digitsApart({1e-3, 1.0, 1e9}), 4);
	EXPECT_EQ(digitsApart({}), 4);
	EXPECT_EQ(labels(ticksAt({101328.0}, 9, false)), (Words{"101328"}));
	for (const double lo : {-101325.0, 0.0, 3e9})
		for (const double range : {0.0078125, 6.0, 1e5})
		{
			const Words words = told(roundLevels(lo, lo + range, 20, false));
			EXPECT_EQ(std::set<std::string>(words.begin(), words.end()).size(), words.size()) << lo << " " << range;
		}
}

TEST(Ticks, OfALogarithmicScale)
{
	EXPECT_EQ(labels(makeLogTicks(0.01, 1000.0, 9)), (Words{"0.01", "0.1", "1", "10", "100", "1000"}));
	EXPECT_EQ(labels(makeLogTicks(3e-9, 2e3, 6)), (Words{"10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰", "10²"}));
	EXPECT_EQ(labels(makeLogTicks(1.5, 40.0, 9)), (Words{"2", "5", "10", "20"}));
	EXPECT_EQ(labels(ticksAt({2e-7, 5e-7, 1e-6}, 9, true)), (Words{"2×10⁻⁷", "5×10⁻⁷", "10⁻⁶"}));
	EXPECT_EQ(makeLogTicks(3.0, 3.0, 9).marks.size(), 1u);
	for (const double lo : {1e-300, 2e-5, 0.3, 7.0, 1e20})
		for (const double factor : {1.001, 1.5, 7.0, 90.0, 1e9, 1e60})
			for (const int most : {2, 3, 9})
			{
				const Ticks ticks = makeLogTicks(lo, lo * factor, most);
				ASSERT_FALSE(ticks.marks.empty());
				EXPECT_LE(ticks.marks.size(), static_cast<std::size_t>(most)) << lo << " " << factor;
				for (const Tick& tick : ticks.marks)
				{
					EXPECT_GE(tick.value, lo);
					EXPECT_LE(tick.value, lo * factor);
				}
			}
}

TEST(Ticks, KeepTheirPromisesOnAnyRange)
{
	for (const double lo : {-1e300, -12345.6, -1.0, -0.1, 0.0, 1e-9, 3.0, 101325.0, 1e12})
		for (const double width : {1e-12, 1e-4, 0.3, 7.0, 999.0, 1e6, 1e290})
			for (const int most : {2, 3, 5, 9})
			{
				const double hi = lo + width;
				const Ticks ticks = makeTicks(lo, hi, most);
				ASSERT_FALSE(ticks.marks.empty()) << lo << " " << hi;
				EXPECT_LE(ticks.marks.size(), static_cast<std::size_t>(most)) << lo << " " << hi;
				for (std::size_t i = 0; i < ticks.marks.size(); ++i)
				{
					EXPECT_GE(ticks.marks[i].value, lo);
					EXPECT_LE(ticks.marks[i].value, hi);
					EXPECT_FALSE(ticks.marks[i].label.empty());
					EXPECT_LE(ticks.marks[i].label.size(), 16u) << lo << " " << hi;
					if (i > 0)
					{
						EXPECT_LT(ticks.marks[i - 1].value, ticks.marks[i].value);
						EXPECT_NE(ticks.marks[i - 1].label, ticks.marks[i].label) << lo << " " << hi;
					}
				}
			}
}

TEST(Ticks, AConstantHasOneMark)
{
	EXPECT_EQ(labels(makeTicks(0.0, 0.0, 5)), Words{"0"});
	EXPECT_EQ(labels(makeTicks(-0.0, 0.0, 5)), Words{"0"});
	EXPECT_EQ(labels(makeTicks(3.25, 3.25, 5)), Words{"3.25"});
	EXPECT_EQ(labels(makeTicks(-2.0, -2.0, 5)), Words{"\u22122"});
	EXPECT_EQ(makeTicks(3.25, 3.25, 5).marks[0].value, 3.25);
}

TEST(Ticks, NoNegativeZero)
{
	for (const Tick& tick : makeTicks(-1.0, 1.0, 5).marks)
	{
		EXPECT_FALSE(std::signbit(tick.value) && tick.value == 0.0);
		EXPECT_NE(tick.label, "\u22120.0");
	}
	EXPECT_EQ(shortNumber(-0.0), "0");
}

TEST(Ticks, HugeAndSmallValuesShareAPowerOfTen)
{
	const Ticks pressure = makeTicks(0.0, 2.5e6, 6);
	EXPECT_EQ(pressure.factor, "×10⁶");
	EXPECT_EQ(labels(pressure), (Words{"0.0", "0.5", "1.0", "1.5", "2.0", "2.5"}));
	const Ticks small = makeTicks(-4e-7, 4e-7, 5);
	EXPECT_EQ(small.factor, "×10⁻⁷");
	EXPECT_EQ(labels(small), (Words{"\u22124", "\u22122", "0", "2", "4"}));
	EXPECT_EQ(makeTicks(0.0, 1000.0, 5).factor, "");
	EXPECT_EQ(makeTicks(0.0, 0.004, 5).factor, "");
	const double most = std::numeric_limits<double>::max();
	EXPECT_FALSE(makeTicks(-most, most, 5).marks.empty());
	EXPECT_EQ(makeTicks(0.0, 1e-310, 5).marks.size(), 1u);
}

TEST(Ticks, OfANarrowAxisFarFromTheOriginDiffer)
{
	for (const double from : {5e5, 6.7e6, 1e7, -1e7})
		for (const double width : {100.0, 1.0, 1e-3})
		{
			const Words all = labels(makeTicks(from, from + width, 6, kNarrowestAxis));
			EXPECT_GE(all.size(), 2u) << from << " " << width;
			EXPECT_EQ(std::set(all.begin(), all.end()).size(), all.size()) << from << " " << width;
		}
	EXPECT_EQ(makeTicks(1e7, 1e7 + 0.1, 6).marks.size(), 1u); // values are in single precision
}

TEST(ShortNumber, ReadsWell)
{
	EXPECT_EQ(shortNumber(1.0), "1");
	EXPECT_EQ(shortNumber(-0.81234), "\u22120.8123");
	EXPECT_EQ(shortNumber(1234567.0), "1.235×10⁶");
	EXPECT_EQ(shortNumber(-1.5e-9), "\u22121.5×10⁻⁹");
}

namespace
{

Words withEnds(double lo, double hi, int most, double apart = 0.1)
{
	Ticks ticks = makeTicks(lo, hi, most);
	addEnds(ticks, lo, hi, apart, false);
	return labels(ticks);
}

} // namespace

// By hand: of 4.512 a tenth is 0.451, so 0.5 and 4.5 are too near to the ends. A thousandth is 0.0045.
TEST(Ticks, EndsHaveLabels)
{
	EXPECT_EQ(withEnds(0.197813, 4.71, 10), (Words{"0.198", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5", "4.0", "4.71"}));
	EXPECT_EQ(withEnds(0.0, 1.0, 6), (Words{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
	EXPECT_EQ(withEnds(-1e-17, 5.0, 6), (Words{"0", "1", "2", "3", "4", "5"}));
	EXPECT_EQ(withEnds(3.0, 3.0, 6), (Words{"3"}));
	EXPECT_EQ(withEnds(1.234e6, 5.678e6, 3), (Words{"1.234", "2", "4", "5.678"})); // times a power of ten
	EXPECT_EQ(withEnds(-12.34, 56.78, 2, 0.4), (Words{"\u221212.34", "56.78"}));
}

TEST(Ticks, EndsOfLogarithmsHaveLabels)
{
	Ticks ticks = makeLogTicks(0.03, 2000.0, 9);
	addEnds(ticks, 0.03, 2000.0, 0.1, true);
	EXPECT_EQ(labels(ticks), (Words{"0.03", "0.1", "1", "10", "100", "2000"}));
}

} // namespace vp::render
