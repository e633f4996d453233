#include "surface/expression_glsl.h"

#include "surface/expression_parsed.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

namespace vp::surface
{

namespace
{

std::string_view functionOf(Operation operation)
{
	switch (operation)
	{
	case Operation::add:
		return "sumOf";
	case Operation::subtract:
		return "differenceOf";
	case Operation::multiply:
		return "productOf";
	case Operation::divide:
		return "quotientOf";
	case Operation::negate:
		return "negativeOf";
	case Operation::square:
		return "squareOf";
	case Operation::integer_power:
		return "powerOf";
	case Operation::pow:
		return "powOf";
	case Operation::abs:
		return "absOf";
	case Operation::sqrt:
		return "sqrtOf";
	case Operation::cbrt:
		return "cbrtOf";
	case Operation::exp:
		return "expOf";
	case Operation::log:
		return "logOf";
	case Operation::log2:
		return "log2Of";
	case Operation::log10:
		return "log10Of";
	case Operation::sin:
		return "sinOf";
	case Operation::cos:
		return "cosOf";
	case Operation::tan:
		return "tanOf";
	case Operation::asin:
		return "asinOf";
	case Operation::acos:
		return "acosOf";
	case Operation::atan:
		return "atanOf";
	case Operation::sinh:
		return "sinhOf";
	case Operation::cosh:
		return "coshOf";
	case Operation::tanh:
		return "tanhOf";
	case Operation::atan2:
		return "atan2Of";
	case Operation::hypot:
		return "hypotOf";
	case Operation::min:
		return "minOf";
	case Operation::max:
		return "maxOf";
	case Operation::x:
	case Operation::y:
	case Operation::z:
	case Operation::number:
		break;
	}
	return "";
}

std::string bitsOf(float number)
{
	return fmt::format("uintBitsToFloat({:#x}u)", std::bit_cast<std::uint32_t>(number));
}

// Beyond a float's range the shader takes it for unknown, as it does all that is very large.
std::string floatLiteral(double number)
{
	constexpr double kOutOfRange = 1e30;
	const auto nearest = static_cast<float>(std::clamp(number, -kOutOfRange, kOutOfRange));
	const float error =
	    std::nextafter(static_cast<float>(std::abs(number - nearest)), std::numeric_limits<float>::max());
	return fmt::format("rounded({}, {})", bitsOf(nearest), bitsOf(std::min(error, 1e30f)));
}

std::string valueOf(const ExpressionNode& node)
{
	if (node.operation == Operation::number)
		return floatLiteral(node.number);
	const std::string_view function = functionOf(node.operation);
	if (node.operation == Operation::integer_power)
		return fmt::format("{}(n{}, {})", function, node.a, node.exponent);
	if (node.b < 0)
		return fmt::format("{}(n{})", function, node.a);
	return fmt::format("{}(n{}, n{})", function, node.a, node.b);
}

// By what bounded.glsl makes of them, compiled for software.
int costOf(Operation operation)
{
	switch (operation)
	{
	case Operation::x:
	case Operation::y:
	case Operation::z:
	case Operation::number:
	case Operation::add:
	case Operation::subtract:
	case Operation::multiply:
	case Operation::divide:
	case Operation::negate:
	case Operation::square:
	case Operation::abs:
	case Operation::min:
	case Operation::max:
		return 1;
	case Operation::pow:
	case Operation::sinh:
	case Operation::cosh:
	case Operation::tanh:
		return 10;
	default:
		return 4;
	}
}

// Folding leaves nodes behind that nothing needs.
std::vector<bool> neededNodes(const ParsedExpression& parsed)
{
	const std::vector<ExpressionNode>& nodes = parsed.tree.nodes();
	std::vector<bool> needed(nodes.size(), false);
	needed[parsed.root] = true;
	for (std::size_t n = nodes.size(); n-- > 0;)
		for (const int operand : {nodes[n].a, nodes[n].b})
			if (needed[n] && operand >= 0)
				needed[operand] = true;
	return needed;
}

} // namespace

int shaderCost(const Expression& expression)
{
	const ParsedExpression& parsed = expression.parsed().expression;
	const std::vector<bool> needed = neededNodes(parsed);
	int sum = 0;
	for (std::size_t n = 0; n < needed.size(); ++n)
		sum += needed[n] ? costOf(parsed.tree.nodes()[n].operation) : 0;
	return sum;
}

std::string glslOf(const Expression& expression)
{
	const ParsedExpression& parsed = expression.parsed().expression;
	const std::vector<ExpressionNode>& nodes = parsed.tree.nodes();
	const std::vector<bool> needed = neededNodes(parsed);
	std::string text = "Bounded surfaceAt(Bounded x, Bounded y, Bounded z)\n{\n";
	for (std::size_t n = 0; n < nodes.size(); ++n)
	{
		if (!needed[n])
			continue;
		const bool variable = nodes[n].operation <= Operation::z;
		text += fmt::format("\tconst Bounded n{} = {};\n", n,
		                    variable ? std::string(1, "xyz"[static_cast<int>(nodes[n].operation)]) : valueOf(nodes[n]));
	}
	return text + fmt::format("\treturn n{};\n}}\n", parsed.root);
}

} // namespace vp::surface
