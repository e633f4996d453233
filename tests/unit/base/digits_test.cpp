#include "base/digits.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

using namespace vp;

namespace
{

std::string words(double lo, double hi, int most = 15)
{
	const int digits = digitsForRange(lo, hi, most);
	return fmt::format("{:.{}g} to {:.{}g}", lo, digits, hi, digits);
}

} // namespace

TEST(Digits, AsManyAsTheWidthNeeds)
{
	EXPECT_EQ(words(0.0, 1.0), "0 to 1");
	EXPECT_EQ(words(-1.0 / 3.0, 2.0 / 3.0), "-0.333333 to 0.666667");
	EXPECT_EQ(words(0.0, 6.7e6), "0 to 6.7e+06");
	EXPECT_EQ(words(6.7e6, 6.7e6 + 1.0), "6700000 to 6700001");
	EXPECT_EQ(words(6.7e6 + 0.12, 6.7e6 + 1.37), "6700000.12 to 6700001.37");
	EXPECT_EQ(words(1e7, 1e7 + 0.125), "10000000 to 10000000.125");
	EXPECT_EQ(words(-6.7e6, -6.7e6 + 0.5), "-6700000 to -6699999.5");
	EXPECT_NE(words(1.0, std::nextafter(1.0, 2.0)), "1 to 1");
}

TEST(Digits, OfSinglePrecisionNoMoreThanItHas)
{
	EXPECT_EQ(words(300.1f, 300.2f, 7), "300.1 to 300.2");
	EXPECT_EQ(words(6.7e6f, 6700000.5f, 7), "6700000 to 6700000.5");
	EXPECT_EQ(words(273.15f, 273.15f, 7), "273.15 to 273.15");
}

TEST(Digits, TellStepsApart)
{
	EXPECT_EQ(digitsFor(1.0, 0.1), 6);
	EXPECT_EQ(digitsFor(1.0, 0.0), 6);
	EXPECT_EQ(digitsFor(0.0, 0.1), 6);
	EXPECT_EQ(digitsFor(1e6, 0.1, 4), 9);
	EXPECT_EQ(digitsFor(1e300, 1e-300), 17);
}
