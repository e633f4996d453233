#include "surface/expression.h"

#include "random_expression.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

namespace vp::test
{

using surface::Expression;

namespace
{

constexpr double kPi = std::numbers::pi;

Expression parsed(const std::string& text)
{
	Result<Expression> made = Expression::parse(text);
	EXPECT_TRUE(made) << text << ": " << made.error().message;
	return *made;
}

// Returns the value of the text at (0.7, -1.3, 2.1).
double valueOf(const std::string& text)
{
	return parsed(text).value({0.7, -1.3, 2.1});
}

const double x = 0.7;
const double y = -1.3;
const double z = 2.1;

std::vector<double> randomNumbers(std::mt19937& random, std::size_t count)
{
	std::vector<double> numbers(count);
	for (double& number : numbers)
		number = std::uniform_real_distribution<double>(-3.0, 3.0)(random);
	return numbers;
}

bool sameBits(double a, double b)
{
	return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

} // namespace

TEST(Expression, Precedence)
{
	EXPECT_EQ(valueOf("x + y*z"), x + y * z);
	EXPECT_EQ(valueOf("x - y - z"), x - y - z);
	EXPECT_EQ(valueOf("x / y / z"), x / y / z);
	EXPECT_EQ(valueOf("x / y * z"), x / y * z);
	EXPECT_EQ(valueOf("-x^2"), -(x * x));
	EXPECT_EQ(valueOf("(-x)^2"), x * x);
	EXPECT_EQ(valueOf("x*-y"), x * -y);
	EXPECT_EQ(valueOf("x - -y"), x + y);
	EXPECT_EQ(valueOf("+x--+-y"), x - y);
	EXPECT_EQ(valueOf("0*x + 2^3^2"), 512.0);
	EXPECT_EQ(valueOf("x*2^-2"), x / 4.0);
	EXPECT_EQ(valueOf("x^2*y"), x * x * y);
	EXPECT_EQ(valueOf("2*x^3"), 2.0 * (x * (x * x)));
	EXPECT_EQ(valueOf("(x + y)*(z - 1)"), (x + y) * (z - 1.0));
	EXPECT_EQ(valueOf(" \t( (x)\n+ y ) "), x + y);
	EXPECT_EQ(valueOf("x*x + y*y = 0.25*z"), x * x + y * y - 0.25 * z);
}

TEST(Expression, Numbers)
{
	EXPECT_EQ(valueOf("x + 1e-3"), x + 1e-3);
	EXPECT_EQ(valueOf("x + .5"), x + 0.5);
	EXPECT_EQ(valueOf("x + 2."), x + 2.0);
	EXPECT_EQ(valueOf("x + 2.5E+2"), x + 250.0);
	EXPECT_EQ(valueOf("x + pi"), x + kPi);
	EXPECT_EQ(valueOf("x + e"), x + std::numbers::e);
}

TEST(Expression, Functions)
{
	// The compiler's own constants may differ from the library's in the last bit.
	EXPECT_DOUBLE_EQ(valueOf("sin(x)"), std::sin(x));
	EXPECT_DOUBLE_EQ(valueOf("cos(x)"), std::cos(x));
	EXPECT_DOUBLE_EQ(valueOf("tan(x)"), std::tan(x));
	EXPECT_DOUBLE_EQ(valueOf("asin(x)"), std::asin(x));
	EXPECT_DOUBLE_EQ(valueOf("acos(x)"), std::acos(x));
	EXPECT_DOUBLE_EQ(valueOf("atan(x)"), std::atan(x));
	EXPECT_DOUBLE_EQ(valueOf("sinh(x)"), std::sinh(x));
	EXPECT_DOUBLE_EQ(valueOf("cosh(x)"), std::cosh(x));
	EXPECT_DOUBLE_EQ(valueOf("tanh(x)"), std::tanh(x));
	EXPECT_DOUBLE_EQ(valueOf("exp(x)"), std::exp(x));
	EXPECT_DOUBLE_EQ(valueOf("ln(x)"), std::log(x));
	EXPECT_DOUBLE_EQ(valueOf("log(x)"), std::log(x));
	EXPECT_DOUBLE_EQ(valueOf("log2(x)"), std::log2(x));
	EXPECT_DOUBLE_EQ(valueOf("log10(x)"), std::log10(x));
	EXPECT_DOUBLE_EQ(valueOf("sqrt(x)"), std::sqrt(x));
	EXPECT_DOUBLE_EQ(valueOf("cbrt(y)"), std::cbrt(y));
	EXPECT_DOUBLE_EQ(valueOf("abs(y)"), -y);
	EXPECT_DOUBLE_EQ(valueOf("atan2(y, x)"), std::atan2(y, x));
	EXPECT_DOUBLE_EQ(valueOf("hypot(y, x)"), std::hypot(y, x));
	EXPECT_DOUBLE_EQ(valueOf("pow(x, z)"), std::pow(x, z));
	EXPECT_DOUBLE_EQ(valueOf("x^z"), std::pow(x, z));
	EXPECT_DOUBLE_EQ(valueOf("min(x, y)"), y);
	EXPECT_DOUBLE_EQ(valueOf("max(x, y, z, 0.5)"), z);
}

TEST(Expression, WholePowersAreMultiplications)
{
	EXPECT_EQ(valueOf("y^2"), y * y);
	EXPECT_EQ(valueOf("pow(y, 3)"), y * (y * y));
	EXPECT_EQ(valueOf("y^5"), y * ((y * y) * (y * y)));
	EXPECT_EQ(valueOf("y^-3"), 1.0 / (y * (y * y)));
	EXPECT_EQ(valueOf("x + y^0"), x + 1.0);
	EXPECT_EQ(valueOf("y^1"), y);
	EXPECT_EQ(valueOf("x*y^1025"), x * std::pow(y, 1025.0));
}

TEST(Expression, WhatIsNoNumberIsNotPositive)
{
	EXPECT_FALSE(parsed("sqrt(x)").value({-1.0, 0.0, 0.0}) >= 0.0);
	EXPECT_TRUE(std::isnan(parsed("min(ln(x), y)").value({-1.0, 2.0, 0.0})));
	EXPECT_TRUE(std::isnan(parsed("max(y, ln(x))").value({-1.0, 2.0, 0.0})));
	EXPECT_FALSE(parsed("sqrt(x) + 1").over({{-1.0, 0.0, 0.0}, {4.0, 1.0, 1.0}}).isBounded());
	EXPECT_FALSE(parsed("atan(1/x) + 9").over({{-1.0, 0.0, 0.0}, {4.0, 1.0, 1.0}}).isBounded());
}

TEST(Expression, ManyPointsHaveTheBitsOfOne)
{
	std::mt19937 random(5);
	for (int round = 0; round < 300; ++round)
	{
		const std::string text = "x + " + randomExpression(random, 5);
		const Result<Expression> made = Expression::parse(text);
		if (!made)
			continue; // folded to what has no finite value
		const std::size_t count = 1 + random() % 200;
		const std::vector<double> px = randomNumbers(random, count);
		const std::vector<double> py = randomNumbers(random, count);
		const std::vector<double> pz = randomNumbers(random, count);
		std::vector<double> out(count);
		made->values(px.data(), py.data(), pz.data(), out.data(), count);
		for (std::size_t i = 0; i < count; ++i)
			ASSERT_TRUE(sameBits(out[i], made->value({px[i], py[i], pz[i]}))) << text << " at point " << i;
	}
}

TEST(Expression, LongestTexts)
{
	std::string sum = "x";
	while (sum.size() + 2 <= 4096)
		sum += "+x";
	EXPECT_EQ(parsed(sum).value({1.0, 0.0, 0.0}), 2048.0);
	std::string right = "(x*";
	for (int i = 0; i < 60; ++i)
		right += "(x+";
	right += "y" + std::string(61, ')');
	EXPECT_EQ(parsed(right).value({1.0, 2.0, 0.0}), 62.0);
	// A tree of 2048 different leaves, which takes the most registers.
	std::string tree = "3";
	for (int depth = 0; depth < 9; ++depth)
		tree = fmt::format("({0}+x*{0})", tree);
	EXPECT_EQ(parsed(tree).value({0.0, 0.0, 0.0}), 3.0);
}

TEST(Expression, GradientsAreThoseOfDifferences)
{
	std::mt19937 random(7);
	int compared = 0;
	for (int round = 0; round < 2000; ++round)
	{
		const std::string text = "x + " + randomExpression(random, 3);
		const Result<Expression> made = Expression::parse(text);
		if (!made)
			continue;
		const std::vector<double> at = randomNumbers(random, 3);
		const Vec3 p(at[0], at[1], at[2]);
		const Vec3 slope = made->gradient(p);
		for (int axis = 0; axis < 3; ++axis)
		{
			const auto difference = [&](double step)
			{
				Vec3 to = p;
				to[axis] += step;
				Vec3 from = p;
				from[axis] -= step;
				return (made->value(to) - made->value(from)) / (2.0 * step);
			};
			// If two step sizes disagree, there is a kink, a pole or too much curvature.
			const double fine = difference(1e-5);
			const double coarse = difference(2e-5);
			if (!(std::abs(fine - coarse) < 1e-6 * (1.0 + std::abs(fine))) || std::abs(made->value(p)) > 1e3)
				continue;
			++compared;
			EXPECT_NEAR(slope[axis], fine, 1e-4 * (1.0 + std::abs(fine))) << text << ", axis " << axis;
		}
	}
	EXPECT_GT(compared, 3000);
}

TEST(Expression, CopiesShareAndCompareByText)
{
	const Expression a = parsed("x*x - y");
	const Expression b = a;
	EXPECT_EQ(a, b);
	EXPECT_EQ(&a.text(), &b.text());
	EXPECT_EQ(a, parsed("x*x - y"));
	EXPECT_FALSE(a == parsed("x*x - z"));
}

} // namespace vp::test
