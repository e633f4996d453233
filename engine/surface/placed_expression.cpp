#include "surface/placed_expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vp::surface
{

PlacedExpression::PlacedExpression(Expression expression, const Axes& axes)
    : expression_(std::move(expression)), axes_(axes), moved_(axes != Axes())
{
}

void PlacedExpression::heightsAt(std::span<const Vec3> places, double* heights) const
{
	constexpr std::size_t kBatch = 64;
	std::array<double, kBatch> x, y, z;
	for (std::size_t begin = 0; begin < places.size(); begin += kBatch)
	{
		const std::size_t count = std::min(kBatch, places.size() - begin);
		for (std::size_t i = 0; i < count; ++i)
		{
			const Vec3 at = local(places[begin + i]);
			x[i] = at.x;
			y[i] = at.y;
			z[i] = at.z;
		}
		expression_.values(x.data(), y.data(), z.data(), heights + begin, count);
	}
}

// Regula falsi by the Illinois rule, which keeps the root between two places of different sign, and halving where that
// is not finite or the places draw together too slowly.
double PlacedExpression::crossing(const Vec3& a, const Vec3& b, double height_a, double height_b) const
{
	double lo = 0.0;
	double hi = 1.0;
	double at_lo = height_a;
	double at_hi = height_b;
	const bool rises = height_b >= 0.0;
	constexpr int kQuick = 24;
	constexpr double kClose = 1e-15;
	for (int step = 0; hi - lo > kClose; ++step)
	{
		double t = lo - at_lo * (hi - lo) / (at_hi - at_lo);
		if (!(t > lo && t < hi) || step > kQuick)
			t = 0.5 * (lo + hi);
		if (t == lo || t == hi)
			break;
		const double height = this->height(a + t * (b - a));
		if (height == 0.0)
			return t;
		const bool is_above = height >= 0.0;
		(is_above == rises ? hi : lo) = t;
		// An end that stays twice counts half from then on.
		if (is_above == rises)
		{
			at_hi = height;
			at_lo *= 0.5;
		}
		else
		{
			at_lo = height;
			at_hi *= 0.5;
		}
	}
	const bool ends_low = std::abs(at_lo) < std::abs(at_hi);
	return ends_low ? lo : hi;
}

bool PlacedExpression::meets(const Box& box) const
{
	if (!moved_)
		return expression_.meets(box);
	const Vec3 centre = local(box.centre());
	const Vec3 half = 0.5 * box.size();
	const Vec3 reach(glm::dot(glm::abs(axes_.x), half), glm::dot(glm::abs(axes_.y), half),
	                 glm::dot(glm::abs(axes_.z), half));
	// Rounding of the centre in the frame.
	const Vec3 far = glm::abs(box.centre()) + glm::abs(axes_.origin) + half;
	const Vec3 slack(1e-15 * (far.x + far.y + far.z));
	return expression_.meets({centre - reach - slack, centre + reach + slack});
}

} // namespace vp::surface
