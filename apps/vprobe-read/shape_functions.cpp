#include "shape_functions.h"

#include <algorithm>
#include <cmath>

using vp::Vec3;

namespace
{

double binomial(int n, int k)
{
	double product = 1.0;
	for (int i = 1; i <= k; ++i)
		product = product * (n - k + i) / i;
	return product;
}

} // namespace

void weighQuadraticPyramid(const Vec3& at, std::span<double> weights)
{
	const double z = at.z;
	const double half = 1.0 - z; // the width at this height, where the base runs from -1 to 1
	if (half <= 0.0)
	{
		std::fill(weights.begin(), weights.end(), 0.0);
		weights[4] = 1.0;
		return;
	}
	const double x = 2.0 * at.x - 1.0;
	const double y = 2.0 * at.y - 1.0;
	constexpr std::array<std::array<int, 2>, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
	for (std::size_t c = 0; c < 4; ++c)
	{
		const double along_x = corners[c][0] * x;
		const double along_y = corners[c][1] * y;
		const double bilinear = (half + along_x) * (half + along_y) / half;
		weights[c] = 0.25 * bilinear * (along_x + along_y - 1.0);
		weights[9 + c] = z * bilinear;
	}
	weights[4] = z * (2.0 * z - 1.0);
	const double within_x = 0.5 * (half + x) * (half - x) / half;
	const double within_y = 0.5 * (half + y) * (half - y) / half;
	weights[5] = within_x * (half - y);
	weights[6] = within_y * (half + x);
	weights[7] = within_x * (half + y);
	weights[8] = within_y * (half - x);
}

void weighBezier(int simplex, const std::array<int, 3>& degrees, std::span<const Vec3> nodes, const Vec3& at,
                 std::span<double> weights)
{
	double rest = 1.0; // the last coordinate in the simplex
	for (int axis = 0; axis < simplex; ++axis)
		rest -= at[axis];
	for (std::size_t node = 0; node < nodes.size(); ++node)
	{
		double weight = 1.0;
		int left = degrees[0]; // of the simplex
		for (int axis = 0; axis < 3; ++axis)
		{
			const auto n = static_cast<int>(std::lround(nodes[node][axis] * degrees[axis]));
			if (axis < simplex)
			{
				weight *= binomial(left, n) * std::pow(at[axis], n);
				left -= n;
			}
			else
				weight *=
				    binomial(degrees[axis], n) * std::pow(at[axis], n) * std::pow(1.0 - at[axis], degrees[axis] - n);
		}
		weights[node] = simplex > 0 ? weight * std::pow(rest, left) : weight;
	}
}
