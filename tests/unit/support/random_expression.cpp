#include "random_expression.h"

#include "surface/expression_tree.h"

#include <fmt/format.h>

namespace vp::test
{

namespace
{

int below(std::mt19937& random, int count)
{
	return std::uniform_int_distribution<int>(0, count - 1)(random);
}

// Constants only beside variables: of constants alone powers may be made that leave no digit of a sine certain.
std::string randomOperand(std::mt19937& random)
{
	const char variable = static_cast<char>('x' + below(random, 3));
	switch (below(random, 6))
	{
	case 0:
		return fmt::format("{}*{}", std::uniform_real_distribution<double>(0.0, 3.0)(random), variable);
	case 1:
		return fmt::format("{}*{}", below(random, 2) ? "pi" : "e", variable);
	default:
		return std::string(1, variable);
	}
}

std::string randomCall(std::mt19937& random, int depth, bool bare)
{
	const surface::NamedFunction& function = surface::kNamedFunctions[below(random, surface::kNamedFunctions.size())];
	std::string call = fmt::format("{}({}", function.name, randomExpression(random, depth - 1, bare));
	for (int i = 1; i < function.arguments() + (function.or_more ? below(random, 2) : 0); ++i)
		call += ", " + randomExpression(random, depth - 1, bare);
	return call + ")";
}

} // namespace

std::string randomExpression(std::mt19937& random, int depth, bool bare)
{
	if (depth == 0)
		return randomOperand(random);
	std::string text;
	switch (below(random, 5))
	{
	case 0:
		return randomCall(random, depth, bare);
	case 1:
		text = randomExpression(random, depth - 1, bare);
		text = text.starts_with('-') ? fmt::format("-({})", text) : fmt::format("-{}", text); // "--x" is not everyone's
		break;
	case 2:
		text = fmt::format("({})^{}", randomExpression(random, depth - 1, bare), 1 + below(random, 5));
		break;
	default:
		text = fmt::format("{} {} {}", randomExpression(random, depth - 1, bare), "+-*/"[below(random, 4)],
		                   randomExpression(random, depth - 1, bare));
	}
	return bare && below(random, 2) ? text : "(" + text + ")";
}

} // namespace vp::test
