#pragma once

#include "surface/axes.h"
#include "surface/expression.h"

#include <span>

namespace vp::surface
{

// An expression of the coordinates in a frame, in the world.
class PlacedExpression
{
public:
	PlacedExpression(Expression expression, const Axes& axes);

	double height(const Vec3& p) const { return expression_.value(local(p)); }
	// height() of each place, some times faster; `heights` has as many.
	void heightsAt(std::span<const Vec3> places, double* heights) const;
	// How far from a to b the surface lies, 0 to 1: the heights have different signs, one of which may be NaN. The root
	// is bracketed to the last bit but a few; towards what is no number it ends where the numbers do.
	double crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const;
	// Whether the surface may pass through the box, its rim included.
	bool meets(const Box& box) const;

	const Expression& expression() const { return expression_; }
	const Axes& axes() const { return axes_; }
	bool isMoved() const { return moved_; } // the frame is not the world's

private:
	Vec3 local(const Vec3& p) const
	{
		if (!moved_)
			return p;
		const Vec3 q = p - axes_.origin;
		return {glm::dot(q, axes_.x), glm::dot(q, axes_.y), glm::dot(q, axes_.z)};
	}

	Expression expression_;
	Axes axes_;
	bool moved_;
};

} // namespace vp::surface
