#include "base/real_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

using namespace vp;

TEST(RealText, OfC)
{
	EXPECT_EQ(parseReal("0"), 0.0);
	EXPECT_EQ(parseReal("+1"), 1.0);
	EXPECT_EQ(parseReal("-.5"), -0.5);
	EXPECT_EQ(parseReal("1."), 1.0);
	EXPECT_EQ(parseReal("1e2"), 100.0);
	EXPECT_EQ(parseReal("1.E+2"), 100.0);
	EXPECT_EQ(parseReal("0.1"), 0.1);
	EXPECT_TRUE(std::signbit(parseReal("-0").value()));
}

TEST(RealText, OfFortran)
{
	EXPECT_EQ(parseReal("1D2"), 100.0);
	EXPECT_EQ(parseReal("-1.5d-2"), -0.015);
	EXPECT_EQ(parseReal("1Q2"), 100.0);
	EXPECT_EQ(parseReal("1.0-100"), 1e-100);
	EXPECT_EQ(parseReal("1.0+100"), 1e100);
	EXPECT_EQ(parseReal("+.12345-101"), 0.12345e-101);
}

TEST(RealText, NoNumbers)
{
	for (const char* word : {"nan", "NaN", "-nan", "+NAN", "nan(ind)", "-nan(0x8000000000000)", "nanq", "1.#QNAN",
	                         "-1.#IND", "-1.#IND00", "1.#SNAN"})
		EXPECT_TRUE(std::isnan(parseReal(word).value_or(0.0))) << word;
}

TEST(RealText, WithoutEnd)
{
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	for (const char* word : {"inf", "Infinity", "+INF", "1.#INF", "1.#INF000", "1e400", "1+400", "1D99999"})
		EXPECT_EQ(parseReal(word), kInfinity) << word;
	for (const char* word : {"-inf", "-Infinity", "-1.#INF", "-1e400"})
		EXPECT_EQ(parseReal(word), -kInfinity) << word;
	for (const char* word : {"1e-400", "0.0000001-400", "1d-999"})
		EXPECT_EQ(parseReal(word), 0.0) << word;
	EXPECT_EQ(parseReal(std::string(400, '9')), kInfinity);
	EXPECT_EQ(parseReal("0." + std::string(400, '0') + "1"), 0.0);
}

TEST(RealText, OtherWords)
{
	for (const char* word :
	     {"",      "+",  "-",  ".",   "e",    "e5",       "--1", "+-1",  "1-",   "1e",  "1D",   "1e5e5",   "1-2-3",
	      "1e+-5", "1 ", " 1", "1,5", "0x10", "infinite", "in",  "nano", "nan(", "1.#", "1.#X", "1.0-1e5", "1d-2d"})
		EXPECT_FALSE(parseReal(word)) << word << " is " << *parseReal(word);
}

TEST(RealText, EveryDoubleComesBack)
{
	std::mt19937_64 random(7);
	for (int i = 0; i < 100000; ++i)
	{
		double value = 0.0;
		const std::uint64_t bits = random();
		std::memcpy(&value, &bits, sizeof value);
		if (!std::isfinite(value))
			continue;
		std::string text = fmt::format("{:.17e}", value);
		ASSERT_EQ(parseReal(text), value) << text;
		text.erase(text.find('e'), 1);
		ASSERT_EQ(parseReal(text), value) << text;
	}
}
