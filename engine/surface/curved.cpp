#include "surface/curved.h"

#include <algorithm>
#include <cmath>

namespace vp::surface
{

double BlockSurface::crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const
{
	if (const Quadric* quadric = this->quadric())
		return quadric->crossing(a, b, height_a, height_b);
	if (const PlacedExpression* expression = this->expression())
		return expression->crossing(a, b, height_a, height_b);
	// Towards what is no number the surface ends where the numbers do.
	if (!std::isfinite(height_a) || !std::isfinite(height_b))
		return std::isfinite(height_a) ? 0.0 : 1.0;
	return std::clamp(Plane::crossing(height_a, height_b), 0.0, 1.0);
}

bool BlockSurface::meets(const Box& box) const
{
	if (const Quadric* quadric = this->quadric())
		return quadric->meets(box);
	const PlacedExpression* expression = this->expression();
	return !expression || expression->meets(box);
}

std::optional<double> BlockSurface::heightAt(const Vec3& place) const
{
	if (const Quadric* quadric = this->quadric())
		return quadric->height(place);
	const PlacedExpression* expression = this->expression();
	return expression ? std::optional(expression->height(place)) : std::nullopt;
}

} // namespace vp::surface
