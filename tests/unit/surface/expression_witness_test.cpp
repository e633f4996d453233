#include "surface/expression.h"

#include "random_expression.h"

#include <gtest/gtest.h>
#include <muParser.h>

#include <cmath>

namespace vp::test
{

namespace
{

// muParser, another's parser, with the names that it lacks.
class Witness
{
public:
	Witness()
	{
		parser_.DefineVar("x", &at_.x);
		parser_.DefineVar("y", &at_.y);
		parser_.DefineVar("z", &at_.z);
		parser_.DefineConst("pi", M_PI);
		parser_.DefineConst("e", M_E);
		parser_.DefineFun(
		    "cbrt", +[](double a) { return std::cbrt(a); });
		parser_.DefineFun(
		    "pow", +[](double a, double b) { return std::pow(a, b); });
		parser_.DefineFun(
		    "hypot", +[](double a, double b) { return std::hypot(a, b); });
	}

	double value(const std::string& text, const Vec3& p)
	{
		parser_.SetExpr(text);
		at_ = p;
		try
		{
			return parser_.Eval();
		}
		catch (const mu::ParserError& error)
		{
			ADD_FAILURE() << text << ": " << error.GetMsg();
			return std::nan("");
		}
	}

private:
	Vec3 at_{0.0};
	mu::Parser parser_;
};

Vec3 randomPoint(std::mt19937& random)
{
	std::uniform_real_distribution<double> number(-3.0, 3.0);
	return {number(random), number(random), number(random)};
}

} // namespace

// Both round, in other orders where powers are multiplied: so the witness is to lie among the values of a tiny box.
TEST(ExpressionWitness, AgreesOnRandomExpressions)
{
	std::mt19937 random(11);
	Witness witness;
	int compared = 0;
	for (int round = 0; round < 4000; ++round)
	{
		const std::string text = "x + " + randomExpression(random, 1 + round % 5);
		const auto made = surface::Expression::parse(text);
		if (!made)
			continue;
		const Vec3 p = randomPoint(random);
		const double value = made->value(p);
		const double other = witness.value(text, p);
		const surface::Interval tiny = made->over({p - Vec3(1e-12), p + Vec3(1e-12)});
		if (!tiny.isBounded())
			continue;
		EXPECT_TRUE(tiny.contains(value)) << text;
		EXPECT_TRUE(tiny.contains(other)) << text << ": " << value << " here, " << other << " there";
		compared += tiny.hi - tiny.lo < 1e-6 * (1.0 + std::abs(value));
	}
	EXPECT_GT(compared, 2000);
}

TEST(ExpressionWitness, ReadsBareTextsAlike)
{
	Witness witness;
	const Vec3 p(0.7, 1.3, 2.1);
	for (const char* text :
	     {"-x^2", "x^y^z", "x-y-z*x/y/z", "-x*-y", "2^-x", "x^-2", "-x^-y", "x - -y", "x/y*z", "x+y*z^2*x-1",
	      "sin(-x)^2", "-sin(x)^2", "1e-3*x", "x*1e+2", "min(x, y, z)", "max(x, y, z)*2"})
		EXPECT_NEAR(surface::Expression::parse(text)->value(p), witness.value(text, p), 1e-12) << text;
}

} // namespace vp::test
