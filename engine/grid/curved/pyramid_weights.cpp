#include "grid/curved/pyramid_weights.h"

#include <algorithm>

namespace vp::grid
{

void weighPyramid(const Vec3& at, std::span<double> weights)
{
	const double z = at.z;
	const double half = 1.0 - z; // the width at this height, where the base runs from -1 to 1
	if (half <= 0.0)
	{
		std::ranges::fill(weights, 0.0);
		weights[4] = 1.0;
		return;
	}
	const double x = 2.0 * at.x - 1.0;
	const double y = 2.0 * at.y - 1.0;
	const bool is_linear = weights.size() == 5;
	for (std::size_t c = 0; c < 4; ++c)
	{
		const double along_x = kPyramidSigns[c][0] * x;
		const double along_y = kPyramidSigns[c][1] * y;
		const double bilinear = (half + along_x) * (half + along_y) / half;
		weights[c] = 0.25 * bilinear;
		if (is_linear)
			continue;
		weights[c] *= along_x + along_y - 1.0;
		weights[9 + c] = z * bilinear;
	}
	weights[4] = is_linear ? z : z * (2.0 * z - 1.0);
	if (is_linear)
		return;
	const double within_x = 0.5 * (half + x) * (half - x) / half;
	const double within_y = 0.5 * (half + y) * (half - y) / half;
	weights[5] = within_x * (half - y);
	weights[6] = within_y * (half + x);
	weights[7] = within_x * (half + y);
	weights[8] = within_y * (half - x);
}

} // namespace vp::grid
