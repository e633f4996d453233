#include "refine/pyramid.h"

#include <algorithm>
#include <array>

namespace vp::refine
{

// With h = 1 - z, the functions are quadratic polynomials and multiples of xy / h, x^2 y / h and x y^2 / h.
PyramidBend::PyramidBend(std::span<const Vec3> nodes)
{
	std::array<Vec3, 6> second{}; // xx, yy, zz, xy, xz, yz
	std::array<Vec3, 3> rational{};
	second.fill(Vec3(0.0));
	rational.fill(Vec3(0.0));
	const bool is_linear = nodes.size() == 5;
	for (std::size_t c = 0; c < 4; ++c)
	{
		const double s = grid::kPyramidSigns[c][0];
		const double t = grid::kPyramidSigns[c][1];
		const Vec3& corner = nodes[c];
		if (is_linear)
		{
			rational[0] += 0.25 * s * t * corner;
			continue;
		}
		second[0] += 0.5 * corner;
		second[1] += 0.5 * corner;
		second[3] += 0.5 * s * t * corner;
		second[4] -= 0.25 * s * corner;
		second[5] -= 0.25 * t * corner;
		rational[0] -= 0.25 * s * t * corner;
		rational[1] += 0.25 * t * corner;
		rational[2] += 0.25 * s * corner;
		const Vec3& upper = nodes[9 + c];
		second[2] -= 2.0 * upper;
		second[3] -= s * t * upper;
		second[4] += s * upper;
		second[5] += t * upper;
		rational[0] += s * t * upper;
	}
	if (!is_linear)
	{
		second[2] += 4.0 * nodes[4];
		for (const std::size_t n : {5, 7})
		{
			const double sign = n == 5 ? 1.0 : -1.0;
			second[0] -= nodes[n];
			second[2] += nodes[n];
			second[5] += 0.5 * sign * nodes[n];
			rational[1] += 0.5 * sign * nodes[n];
		}
		for (const std::size_t n : {6, 8})
		{
			const double sign = n == 8 ? 1.0 : -1.0;
			second[1] -= nodes[n];
			second[2] += nodes[n];
			second[4] += 0.5 * sign * nodes[n];
			rational[2] += 0.5 * sign * nodes[n];
		}
	}
	for (std::size_t i = 0; i < 6; ++i)
		second_[i] = glm::length(second[i]);
	for (std::size_t i = 0; i < 3; ++i)
		rational_[i] = glm::length(rational[i]);
}

double PyramidBend::within(const Vec3& lo, const Vec3& hi) const
{
	const double x = 2.0 * (hi.x - lo.x);
	const double y = 2.0 * (hi.y - lo.y);
	const double z = hi.z - lo.z;
	double bend = second_[0] * x * x + second_[1] * y * y + second_[2] * z * z +
	              2.0 * (second_[3] * x * y + second_[4] * x * z + second_[5] * y * z);
	// |x| and |y| are at most h. So the second derivatives of the last two are bounded, and those of the first by 2 /
	// h.
	bend += rational_[1] * 2.0 * (x * x + z * z + 2.0 * x * y + 2.0 * x * z + y * z);
	bend += rational_[2] * 2.0 * (y * y + z * z + 2.0 * x * y + 2.0 * y * z + x * z);
	bend /= 8.0;
	const double least = 1.0 - hi.z;
	double of_first = 2.0 * (1.0 - lo.z); // |xy / h| is at most h
	if (least > 0.0)
		of_first = std::min(of_first, 0.25 * (x * y + x * z + y * z + z * z) / least);
	return bend + rational_[0] * of_first;
}

} // namespace vp::refine
