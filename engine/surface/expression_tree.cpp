#include "surface/expression_tree.h"

#include "surface/expression_operations.h"

#include <bit>

namespace vp::surface
{

int ExpressionTree::number(double value)
{
	return intern({Operation::number, 0, -1, -1, value});
}

int ExpressionTree::variable(Operation which)
{
	return intern({which});
}

int ExpressionTree::apply(Operation operation, int a, int b)
{
	const bool folds = isNumber(a) && (b < 0 || isNumber(b));
	if (operation == Operation::pow && isNumber(b))
	{
		const double exponent = nodes_[b].number;
		if (exponent == std::trunc(exponent) && std::abs(exponent) <= kMaxExponent)
			return power(a, exponent);
	}
	if (folds)
		return number(
		    withOperation(operation, 0, [&](auto f) { return f(nodes_[a].number, b < 0 ? 0.0 : nodes_[b].number); }));
	if (operation == Operation::multiply && a == b)
		return intern({Operation::square, 0, a});
	return intern({operation, 0, a, b});
}

int ExpressionTree::power(int a, double exponent)
{
	const int n = static_cast<int>(exponent);
	if (isNumber(a))
		return number(integerPower(nodes_[a].number, n));
	if (n == 0)
		return number(1.0);
	if (n == 1)
		return a;
	if (n == 2)
		return intern({Operation::square, 0, a});
	return intern({Operation::integer_power, n, a});
}

int ExpressionTree::intern(const ExpressionNode& node)
{
	const Key key{node.operation, node.exponent, node.a, node.b, std::bit_cast<std::uint64_t>(node.number)};
	const auto [at, is_new] = known_.try_emplace(key, static_cast<int>(nodes_.size()));
	if (is_new)
		nodes_.push_back(node);
	return at->second;
}

} // namespace vp::surface
