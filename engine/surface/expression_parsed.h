#pragma once

#include "surface/expression.h"
#include "surface/expression_program.h"

namespace vp::surface
{

// The data that copies of an expression share.
struct Expression::Parsed
{
	std::string text;
	ParsedExpression expression;
	ExpressionProgram program;
};

} // namespace vp::surface
