#pragma once

#include "surface/axes.h"
#include "surface/expression.h"

#include <span>

namespace vp::surface
{

// An expression of the coordinates in a frame, placed in the world.
class PlacedExpression
{
public:
	PlacedExpression(Expression expression, const Axes& axes);

	double height(const Vec3& p) const { return expression_.value(local(p)); }
	// Writes height() of each place, several times faster. `heights` must have room for them.
	void heightsAt(std::span<const Vec3> places, double* heights) const;
	// Returns the place of the surface on the way from a to b, 0 to 1. The heights must have different signs; one may
	// be NaN. The root is exact but for the last few bits. Toward NaN it is the place where the numbers end.
	double crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const;
	// Returns true if the surface may pass through the box, its rim included.
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
