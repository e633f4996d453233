#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace vp::surface
{

// The operation of an expression's node on its operands a and b.
enum class Operation : std::uint8_t
{
	x,
	y,
	z,
	number,
	add,
	subtract,
	multiply,
	divide,
	negate,
	square,
	integer_power, // a to the node's exponent, by multiplication
	pow,
	abs,
	sqrt,
	cbrt,
	exp,
	log,
	log2,
	log10,
	sin,
	cos,
	tan,
	asin,
	acos,
	atan,
	sinh,
	cosh,
	tanh,
	atan2,
	hypot,
	min,
	max
};

constexpr bool takesTwo(Operation operation)
{
	switch (operation)
	{
	case Operation::add:
	case Operation::subtract:
	case Operation::multiply:
	case Operation::divide:
	case Operation::pow:
	case Operation::atan2:
	case Operation::hypot:
	case Operation::min:
	case Operation::max:
		return true;
	default:
		return false;
	}
}

// A function that may be called by name. All of them are continuous where they are defined, except atan2 across y = 0
// where x < 0.
struct NamedFunction
{
	std::string_view name;
	Operation operation;
	bool or_more = false; // arguments; else one or two

	constexpr int arguments() const { return takesTwo(operation) ? 2 : 1; }
};
inline constexpr std::array kNamedFunctions{
    NamedFunction{"abs", Operation::abs},       NamedFunction{"acos", Operation::acos},
    NamedFunction{"asin", Operation::asin},     NamedFunction{"atan", Operation::atan},
    NamedFunction{"atan2", Operation::atan2},   NamedFunction{"cbrt", Operation::cbrt},
    NamedFunction{"cos", Operation::cos},       NamedFunction{"cosh", Operation::cosh},
    NamedFunction{"exp", Operation::exp},       NamedFunction{"hypot", Operation::hypot},
    NamedFunction{"ln", Operation::log},        NamedFunction{"log", Operation::log},
    NamedFunction{"log10", Operation::log10},   NamedFunction{"log2", Operation::log2},
    NamedFunction{"max", Operation::max, true}, NamedFunction{"min", Operation::min, true},
    NamedFunction{"pow", Operation::pow},       NamedFunction{"sin", Operation::sin},
    NamedFunction{"sinh", Operation::sinh},     NamedFunction{"sqrt", Operation::sqrt},
    NamedFunction{"tan", Operation::tan},       NamedFunction{"tanh", Operation::tanh},
};

struct ExpressionNode
{
	Operation operation = Operation::number;
	std::int32_t exponent = 0; // exponent of integer_power
	std::int32_t a = -1;       // operands, by their place among the nodes; -1: none
	std::int32_t b = -1;
	double number = 0.0;
};

// The nodes of an expression, operands before what they are operands of. Equal nodes are one, constants are folded, and
// what is multiplied by itself is a square: intervals need to know that x*x is not negative.
class ExpressionTree
{
public:
	// Powers by multiplication are wrong by an ulp or so for each factor; beyond this pow() takes over.
	static constexpr int kMaxExponent = 1024;

	// Each gives the node's place.
	int number(double value);
	int variable(Operation which); // x, y, z
	int apply(Operation operation, int a, int b = -1);

	const std::vector<ExpressionNode>& nodes() const { return nodes_; }
	bool isNumber(int node) const { return nodes_[node].operation == Operation::number; }

private:
	int power(int a, double exponent);
	int intern(const ExpressionNode& node);

	struct Key
	{
		Operation operation;
		std::int32_t exponent, a, b;
		std::uint64_t number; // its bits
		auto operator<=>(const Key&) const = default;
	};

	std::vector<ExpressionNode> nodes_;
	std::map<Key, int> known_;
};

} // namespace vp::surface
