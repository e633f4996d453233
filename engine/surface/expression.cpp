#include "surface/expression.h"

#include "surface/dual.h"
#include "surface/expression_parsed.h"

namespace vp::surface
{

Result<Expression> Expression::parse(const std::string& text)
{
	Result<ParsedExpression> parsed = parseExpression(text);
	if (!parsed)
		return parsed.error();
	ExpressionProgram program(*parsed);
	return Expression(std::make_shared<const Parsed>(Parsed{text, std::move(*parsed), std::move(program)}));
}

const std::string& Expression::text() const
{
	return parsed_->text;
}

double Expression::value(const Vec3& p) const
{
	return parsed_->program.value(p.x, p.y, p.z);
}

void Expression::values(const double* x, const double* y, const double* z, double* out, std::size_t count) const
{
	parsed_->program.values(x, y, z, out, count);
}

Interval Expression::over(const Box& box) const
{
	return parsed_->program.run<Interval>(Interval{box.lo.x, box.hi.x}, Interval{box.lo.y, box.hi.y},
	                                      Interval{box.lo.z, box.hi.z}, Interval::of,
	                                      [](Operation operation, int exponent, const Interval& a, const Interval& b)
	                                      { return applied(operation, exponent, a, b); });
}

Vec3 Expression::gradient(const Vec3& p) const
{
	return parsed_->program
	    .run<Dual>(
	        {p.x, {1.0, 0.0, 0.0}}, {p.y, {0.0, 1.0, 0.0}}, {p.z, {0.0, 0.0, 1.0}},
	        [](double number) { return Dual{number}; },
	        [](Operation operation, int exponent, const Dual& a, const Dual& b)
	        { return applied(operation, exponent, a, b); })
	    .slope;
}

} // namespace vp::surface
