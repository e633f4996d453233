#include "shape_functions.h"

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
