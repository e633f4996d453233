#include "surface/expression_glsl.h"

#include "random_expression.h"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace vp::test
{

namespace
{

std::string glslOf(const std::string& text)
{
	return surface::glslOf(*surface::Expression::parse(text));
}

} // namespace

TEST(ExpressionGlsl, IsWrittenFromTheTree)
{
	EXPECT_EQ(glslOf(" x*x+ y*y\n= 0.25*z"), "Bounded surfaceAt(Bounded x, Bounded y, Bounded z)\n"
	                                         "{\n"
	                                         "\tconst Bounded n0 = x;\n"
	                                         "\tconst Bounded n1 = squareOf(n0);\n"
	                                         "\tconst Bounded n2 = y;\n"
	                                         "\tconst Bounded n3 = squareOf(n2);\n"
	                                         "\tconst Bounded n4 = sumOf(n1, n3);\n"
	                                         "\tconst Bounded n5 = rounded(uintBitsToFloat(0x3e800000u), "
	                                         "uintBitsToFloat(0x1u));\n"
	                                         "\tconst Bounded n6 = z;\n"
	                                         "\tconst Bounded n7 = productOf(n5, n6);\n"
	                                         "\tconst Bounded n8 = differenceOf(n4, n7);\n"
	                                         "\treturn n8;\n"
	                                         "}\n");
}

TEST(ExpressionGlsl, LeavesOutWhatFoldingLeftBehind)
{
	EXPECT_EQ(glslOf("x - 2*3").find("n1 "), std::string::npos);
	EXPECT_EQ(glslOf("(x + 1)*(x + 1)").find("productOf"), std::string::npos);
}

TEST(ExpressionGlsl, HoldsOperationsPlacesAndBitsAndNothingElse)
{
	const std::regex allowed("(Bounded surfaceAt\\(Bounded x, Bounded y, Bounded z\\)|\\{|\\}|\treturn n[0-9]+;|"
	                         "\tconst Bounded n[0-9]+ = ([xyz]|rounded\\(uintBitsToFloat\\(0x[0-9a-f]+u\\), "
	                         "uintBitsToFloat\\(0x[0-9a-f]+u\\)\\)|[a-z0-9]+Of\\(n[0-9]+(, (n[0-9]+|-?[0-9]+))?\\));)");
	std::mt19937 random(31);
	for (int round = 0; round < 300; ++round)
	{
		const std::string text = "x + " + randomExpression(random, 1 + round % 6);
		if (!surface::Expression::parse(text))
			continue;
		std::istringstream lines(glslOf(text));
		for (std::string line; std::getline(lines, line);)
			ASSERT_TRUE(std::regex_match(line, allowed)) << line;
	}
}

TEST(ExpressionGlsl, CostsWhatItHas)
{
	const auto cost = [](const char* text) { return surface::shaderCost(*surface::Expression::parse(text)); };
	EXPECT_EQ(cost("x + y"), 3);
	EXPECT_EQ(cost("x*x"), 2);
	EXPECT_EQ(cost("sin(x) - sin(x)*2"), 8);
	EXPECT_EQ(cost("tanh(x)"), 11);
}

} // namespace vp::test
