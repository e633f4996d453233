#include "surface/expression.h"

#include <gtest/gtest.h>

namespace vp::test
{

namespace
{

std::string errorOf(const std::string& text)
{
	const Result<surface::Expression> made = surface::Expression::parse(text);
	EXPECT_FALSE(made) << text;
	if (made)
		return {};
	EXPECT_EQ(made.error().kind, ErrorKind::usage);
	EXPECT_EQ(made.error().message.find('\n'), std::string::npos);
	return made.error().message;
}

const std::string kOperand = "expected a number, a variable, a function or \"(\"";

} // namespace

TEST(ExpressionErrors, NameTheColumnAndTheReason)
{
	EXPECT_EQ(errorOf(""), "column 1: " + kOperand);
	EXPECT_EQ(errorOf("  "), "column 3: " + kOperand);
	EXPECT_EQ(errorOf("x + *y"), "column 5: " + kOperand + " after \"+\"");
	EXPECT_EQ(errorOf("x *"), "column 4: " + kOperand + " after \"*\"");
	EXPECT_EQ(errorOf("x + ."), "column 5: " + kOperand + " after \"+\"");
	EXPECT_EQ(errorOf("2x"), "column 2: expected an operator, not \"x\"");
	EXPECT_EQ(errorOf("x y"), "column 3: expected an operator, not \"y\"");
	EXPECT_EQ(errorOf("x; rm"), "column 2: expected an operator, not \";\"");
	EXPECT_EQ(errorOf("x 1e"), "column 3: expected an operator, not \"1\"");
	EXPECT_EQ(errorOf("(x + y"), "column 7: expected \")\" for the \"(\" in column 1");
	EXPECT_EQ(errorOf("(x + y z)"), "column 8: expected an operator or \")\", not \"z\"");
	EXPECT_EQ(errorOf("x + y)"), "column 6: there is no \"(\" for this \")\"");
	EXPECT_EQ(errorOf("()"), "column 2: " + kOperand + " after \"(\"");
	EXPECT_EQ(errorOf("x = y = z"), "column 7: an equation has one \"=\"");
	EXPECT_EQ(errorOf("x**2"), "column 2: powers are written with \"^\", not with \"**\"");
	EXPECT_EQ(errorOf("x + 1e999"), "column 5: \"1e999\" is out of the range of double precision");
	EXPECT_EQ(errorOf("x + 1/0"), "column 6: this has no finite value");
	EXPECT_EQ(errorOf("x + ln(0)"), "column 5: this has no finite value");
}

TEST(ExpressionErrors, OfNamesAndCalls)
{
	EXPECT_EQ(
	    errorOf("x + foo(y)"),
	    "column 5: unknown name \"foo\"; there are x, y, z, pi, e, abs, acos, asin, atan, atan2, cbrt, cos, cosh, "
	    "exp, hypot, ln, log, log10, log2, max, min, pow, sin, sinh, sqrt, tan, tanh");
	EXPECT_TRUE(errorOf("X").starts_with("column 1: unknown name \"X\""));
	EXPECT_TRUE(errorOf("x + " + std::string(1000, 'a'))
	                .starts_with("column 5: unknown name \"" + std::string(32, 'a') + "...\""));
	EXPECT_EQ(errorOf("sin x"), "column 5: expected \"(\" after \"sin\"");
	EXPECT_EQ(errorOf("x + sin"), "column 8: expected \"(\" after \"sin\"");
	EXPECT_EQ(errorOf("sin(x, y)"), "column 1: sin takes 1 argument, not 2");
	EXPECT_EQ(errorOf("y + atan2(x)"), "column 5: atan2 takes 2 arguments, not 1");
	EXPECT_EQ(errorOf("atan2(x, y, z)"), "column 1: atan2 takes 2 arguments, not 3");
	EXPECT_EQ(errorOf("min(x)"), "column 1: min takes 2 or more arguments, not 1");
	EXPECT_EQ(errorOf("max(x,)"), "column 7: " + kOperand + " after \",\"");
	EXPECT_EQ(errorOf("sin(x"), "column 6: expected \")\" for the \"(\" in column 4");
}

TEST(ExpressionErrors, ConstantsAreRefused)
{
	EXPECT_EQ(errorOf("1"), "column 1: the expression is constant: it needs x, y or z");
	EXPECT_EQ(errorOf("2*pi = sin(e)"), "column 1: the expression is constant: it needs x, y or z");
	EXPECT_EQ(errorOf("x^0"), "column 1: the expression is constant: it needs x, y or z");
}

TEST(ExpressionErrors, AnyBytesGiveOneLine)
{
	EXPECT_EQ(errorOf(std::string("x + \0y", 6)), "column 5: " + kOperand + " after \"+\"");
	EXPECT_EQ(errorOf(std::string("x\0y", 3)), "column 2: expected an operator, not the byte 0x00");
	EXPECT_EQ(errorOf("x \x1b[0m"), "column 3: expected an operator, not the byte 0x1B");
	// Columns count characters, not bytes.
	EXPECT_EQ(errorOf("x + é"), "column 5: " + kOperand + " after \"+\"");
	EXPECT_EQ(errorOf("x é y"), "column 3: expected an operator, not the byte 0xC3");
}

TEST(ExpressionErrors, LengthAndNestingAreBounded)
{
	std::string sum = "x";
	while (sum.size() <= 4096)
		sum += "+x";
	EXPECT_EQ(errorOf(sum), "column 4097: an expression has 4096 characters at most");
	for (const char* nested : {"(", "-", "x^", "sin(", "1-("})
	{
		std::string text;
		for (int i = 0; i < 1000; ++i)
			text += nested;
		EXPECT_NE(errorOf(text).find("nested deeper than 64 levels"), std::string::npos) << nested;
	}
}

} // namespace vp::test
