#include "surface/curved.h"

#include <algorithm>
#include <cmath>

namespace vp::surface
{

double BlockSurface::crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const
{
	const Quadric* quadric = this->quadric();
	const PlacedExpression* expression = this->expression();
	if (quadric || expression)
	{
		// Both orders ask for the root from the same end, the positive one.
		const bool a_positive = height_a >= 0.0;
		const Vec3& from = a_positive ? a : b;
		const Vec3& to = a_positive ? b : a;
		const double height_from = a_positive ? height_a : height_b;
		const double height_to = a_positive ? height_b : height_a;
		const double rest = 1.0 - (quadric ? quadric->crossing(from, to, height_from, height_to)
		                                   : expression->crossing(from, to, height_from, height_to));
		return a_positive ? 1.0 - rest : rest; // neither is rounded once more, as in Plane::crossing()
	}
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
