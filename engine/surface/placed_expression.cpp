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
	struct End
	{
		double t;
		double height;
		double weight = 1.0; // halved while the end stays
	};
	End lo{0.0, height_a};
	End hi{1.0, height_b};
	const bool rises = height_b >= 0.0;
	constexpr int kQuick = 24;
	constexpr double kClose = 1e-15;
	const End* stayed = nullptr;
	for (int step = 0; hi.t - lo.t > kClose; ++step)
	{
		const double at_lo = lo.weight * lo.height;
		double t = lo.t - at_lo * (hi.t - lo.t) / (hi.weight * hi.height - at_lo);
		if (!(t > lo.t && t < hi.t) || step > kQuick)
			t = 0.5 * (lo.t + hi.t);
		if (t == lo.t || t == hi.t)
			break;
		const double height = this->height(a + t * (b - a));
		if (height == 0.0)
			return t;
		End& moves = (height >= 0.0) == rises ? hi : lo;
		End& stays = &moves == &hi ? lo : hi;
		if (stayed == &stays)
			stays.weight *= 0.5;
		stayed = &stays;
		moves = {t, height};
	}
	return std::abs(lo.height) < std::abs(hi.height) ? lo.t : hi.t;
}

bool PlacedExpression::meets(const Box& box) const
{
	if (!moved_)
		return expression_.meets(box);
	const Vec3 center = local(box.center());
	const Vec3 half = 0.5 * box.size();
	const Vec3 reach(glm::dot(glm::abs(axes_.x), half), glm::dot(glm::abs(axes_.y), half),
	                 glm::dot(glm::abs(axes_.z), half));
	// Rounding of the center in the frame.
	const Vec3 far = glm::abs(box.center()) + glm::abs(axes_.origin) + half;
	const Vec3 slack(1e-15 * (far.x + far.y + far.z));
	return expression_.meets({center - reach - slack, center + reach + slack});
}

} // namespace vp::surface
