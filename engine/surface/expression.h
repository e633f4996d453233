#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "surface/interval.h"

#include <cstddef>
#include <memory>
#include <string>

namespace vp::surface
{

// A cutting surface f(x, y, z) = 0, f given as text. S(p) = 1 where value(p) >= 0; a value that is not a number counts
// as not positive. A value type, cheap to copy: copies share what was parsed, which nothing changes. Thread safe.
class Expression
{
public:
	// Numbers (also 1e-3, with a point in any locale), x, y, z, pi, e, + - * / ^, parentheses and functions
	// (kNamedFunctions). "^" binds most tightly and to the right: -x^2 is -(x^2), 2^3^2 is 2^(3^2). Whole powers up to
	// 1024 are multiplications. "left = right" stands for left - right.
	// A usage error without the option's name is one line with the column, from 1, and the reason. Any text may come:
	// its length (4096 characters) and nesting (64 levels) are bounded. What holds no variable is refused.
	static Result<Expression> parse(const std::string& text);

	const std::string& text() const; // as it was given

	// The same bits for the same point, whoever asks.
	double value(const Vec3& p) const;
	double signedDistance(const Vec3& p) const { return value(p); } // not a distance, but its sign is: as Plane has it

	// value() of `count` points, some times faster. `out` may be one of the inputs.
	void values(const double* x, const double* y, const double* z, double* out, std::size_t count) const;

	// Contains value() of every point of the box, which is not empty; see applied() in interval.h for its slack.
	Interval over(const Box& box) const;
	// Returns true if the surface may pass through the box, its rim included.
	bool meets(const Box& box) const { return over(box).hasBothSides(); }

	// Returns the gradient of value(); it is not finite where there is none.
	Vec3 gradient(const Vec3& p) const;

	// The same text.
	bool operator==(const Expression& other) const { return text() == other.text(); }

	struct Parsed;
	const Parsed& parsed() const { return *parsed_; } // expression_parsed.h: for what writes it in another language

private:
	explicit Expression(std::shared_ptr<const Parsed> parsed) : parsed_(std::move(parsed)) {}

	std::shared_ptr<const Parsed> parsed_;
};

} // namespace vp::surface
