#pragma once

#include "base/result.h"
#include "surface/expression_tree.h"

#include <string_view>

namespace vp::surface
{

inline constexpr std::size_t kMaxExpressionText = 4096; // characters
inline constexpr int kMaxExpressionNesting = 64;        // nesting of parentheses, signs and powers

struct ParsedExpression
{
	ExpressionTree tree;
	int root; // its place among the nodes; never a number
};

// See Expression::parse().
Result<ParsedExpression> parseExpression(std::string_view text);

} // namespace vp::surface
