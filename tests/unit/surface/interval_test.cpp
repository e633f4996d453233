#include "surface/expression.h"

#include "random_expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vp::test
{

using surface::Expression;
using surface::Interval;

namespace
{

Interval over(const std::string& text, const Box& box)
{
	return Expression::parse(text)->over(box);
}

Box randomBox(std::mt19937& random)
{
	std::uniform_real_distribution<double> number(-3.0, 3.0);
	const double size = std::exp2(std::uniform_real_distribution<double>(-12.0, 1.0)(random));
	Box box;
	const Vec3 corner(number(random), number(random), number(random));
	box.include(corner);
	box.include(corner + size);
	return box;
}

// Corners as often as what lies between.
Vec3 randomPointOf(const Box& box, std::mt19937& random)
{
	std::uniform_real_distribution<double> part(-0.5, 1.5);
	Vec3 p;
	for (int axis = 0; axis < 3; ++axis)
		p[axis] = std::clamp(box.lo[axis] + part(random) * box.size()[axis], box.lo[axis], box.hi[axis]);
	return p;
}

} // namespace

TEST(Interval, ContainsEveryValueOfABox)
{
	std::mt19937 random(3);
	int bounded = 0;
	int decided = 0;
	for (int round = 0; round < 6000; ++round)
	{
		const std::string text = "x + " + randomExpression(random, 1 + round % 4);
		const auto made = Expression::parse(text);
		if (!made)
			continue;
		const Box box = randomBox(random);
		const Interval all = made->over(box);
		bounded += all.isBounded();
		decided += !all.hasBothSides();
		for (int i = 0; i < 30; ++i)
		{
			const Vec3 p = randomPointOf(box, random);
			const double value = made->value(p);
			ASSERT_TRUE(std::isnan(value) ? !all.isBounded() : all.contains(value))
			    << text << " is " << value << " at " << p.x << ' ' << p.y << ' ' << p.z << ", not in " << all.lo << ".."
			    << all.hi;
		}
	}
	EXPECT_GT(bounded, 3000);
	EXPECT_GT(decided, 2000);
}

TEST(Interval, IsTightWhereEachVariableStandsOnce)
{
	const Box box{{-1.0, 2.0, -3.0}, {2.0, 3.0, -1.0}};
	const auto expectNear = [&](const char* text, double lo, double hi)
	{
		const Interval all = over(text, box);
		EXPECT_NEAR(all.lo, lo, 1e-12) << text;
		EXPECT_NEAR(all.hi, hi, 1e-12) << text;
	};
	expectNear("x*x", 0.0, 4.0);
	expectNear("(x - 1)*(x - 1)", 0.0, 4.0);
	expectNear("x^3", -1.0, 8.0);
	expectNear("x^4", 0.0, 16.0);
	expectNear("z^-2", 1.0 / 9.0, 1.0);
	expectNear("x*y", -3.0, 6.0);
	expectNear("x/y", -0.5, 1.0);
	expectNear("x + y - z", 2.0, 8.0);
	expectNear("sin(pi/2*x)", -1.0, 1.0);
	expectNear("cos(x/10)", std::cos(0.2), 1.0);
	expectNear("sin(y)", std::sin(3.0), std::sin(2.0));
	expectNear("tan(x/2)", std::tan(-0.5), std::tan(1.0));
	expectNear("sqrt(x*x + y*y)", 2.0, std::sqrt(13.0));
	expectNear("hypot(x, y)", 2.0, std::sqrt(13.0));
	expectNear("abs(x)", 0.0, 2.0);
	expectNear("cosh(x)", 1.0, std::cosh(2.0));
	expectNear("pow(y, x)", 1.0 / 3.0, 9.0);
	expectNear("atan2(y, x)", std::atan2(2.0, 2.0), std::atan2(2.0, -1.0));
	expectNear("atan2(x, z)", -M_PI, M_PI);
	expectNear("min(x, y)", -1.0, 2.0);
	expectNear("max(x, 0)", 0.0, 2.0);
	expectNear("exp(x)", std::exp(-1.0), std::exp(2.0));
	expectNear("acos(x/4)", std::acos(0.5), std::acos(-0.25));
}

TEST(Interval, IsTheWholeLineWhereABoundIsNotKnown)
{
	const Box box{{-1.0, 0.0, -3.0}, {2.0, 3.0, -1.0}};
	for (const char* text : {"1/x", "1/y", "x^-2", "sqrt(x)", "ln(y)", "asin(x)", "tan(y)", "pow(x, y)", "z^y", "y^x",
	                         "exp(exp(exp(y + 2)))", "1/x - 1/x", "sin(1/x)", "y^-1"})
		EXPECT_FALSE(over(text, box).isBounded()) << text;
}

// A logarithm reaches to -infinity, and 0 times that is no number.
TEST(Interval, OfALogarithmThatHasNoLeastValueIsTheWholeLine)
{
	const Box box{{-1.0, 0.0, 1.0}, {2.0, 3.0, 2.0}};
	for (const char* text : {"ln(y)", "log(y)", "log2(y)", "ln(x)"})
		EXPECT_EQ(over(text, box).hi, std::numeric_limits<double>::infinity()) << text;
	EXPECT_TRUE(over("ln(z)", box).isBounded());
}

TEST(Interval, TellsBoxesThatASphereMisses)
{
	const Expression sphere = *Expression::parse("x^2 + y^2 + z^2 = 4");
	EXPECT_FALSE(sphere.meets({{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}));
	EXPECT_FALSE(sphere.meets({{2.01, -1.0, -1.0}, {3.0, 1.0, 1.0}}));
	EXPECT_TRUE(sphere.meets({{1.9, -1.0, -1.0}, {3.0, 1.0, 1.0}}));
	EXPECT_TRUE(sphere.meets({{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}})); // its corner lies on it
}

} // namespace vp::test
