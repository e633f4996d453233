#pragma once

#include "base/four_floats.h"
#include "base/ids.h"
#include "base/vec.h"

#include <algorithm>
#include <array>
#include <limits>

namespace vp::surface
{

// The coordinates of four points.
struct FourPoints
{
	FourFloats x;
	FourFloats y;
	FourFloats z;
};

// Loads four points that follow each other.
inline FourPoints loadFour(const float* xyz)
{
#ifdef __SSE2__
	const __m128 a = _mm_loadu_ps(xyz);     // x0 y0 z0 x1
	const __m128 b = _mm_loadu_ps(xyz + 4); // y1 z1 x2 y2
	const __m128 c = _mm_loadu_ps(xyz + 8); // z2 x3 y3 z3
	const __m128 x2y2x3y3 = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));
	const __m128 y0z0y1z1 = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));
	return {_mm_shuffle_ps(a, x2y2x3y3, _MM_SHUFFLE(2, 0, 3, 0)),
	        _mm_shuffle_ps(y0z0y1z1, x2y2x3y3, _MM_SHUFFLE(3, 1, 2, 0)),
	        _mm_shuffle_ps(y0z0y1z1, c, _MM_SHUFFLE(3, 0, 3, 1))};
#else
	const auto along = [&](int axis) { return std::array{xyz[axis], xyz[3 + axis], xyz[6 + axis], xyz[9 + axis]}; };
	return {along(0), along(1), along(2)};
#endif
}

inline FourPoints loadFour(const double* xyz)
{
	float rounded[12];
	std::transform(xyz, xyz + 12, rounded, [](double value) { return static_cast<float>(value); });
	return loadFour(rounded);
}

// Loads four points from anywhere.
inline FourPoints gatherFour(const std::array<const float*, 4>& p)
{
#ifdef __SSE2__
	const auto twice = [](const float* first, const float* second)
	{
		const __m128 low = _mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(first));
		return _mm_loadh_pi(low, reinterpret_cast<const __m64*>(second));
	};
	const __m128 xy01 = twice(p[0], p[1]);
	const __m128 xy23 = twice(p[2], p[3]);
	return {_mm_shuffle_ps(xy01, xy23, _MM_SHUFFLE(2, 0, 2, 0)), _mm_shuffle_ps(xy01, xy23, _MM_SHUFFLE(3, 1, 3, 1)),
	        _mm_set_ps(p[3][2], p[2][2], p[1][2], p[0][2])};
#else
	const auto along = [&](int axis) { return std::array{p[0][axis], p[1][axis], p[2][axis], p[3][axis]}; };
	return {along(0), along(1), along(2)};
#endif
}

inline FourPoints gatherFour(const std::array<const double*, 4>& p)
{
	float rounded[12];
	for (int v = 0; v < 4; ++v)
		for (int axis = 0; axis < 3; ++axis)
			rounded[3 * v + axis] = static_cast<float>(p[v][axis]);
	return loadFour(rounded);
}

// How far points reach along an axis from an origin, in float: off by less than doubt().
class PointHeights
{
public:
	// bounds: of the points. The height in float, as x a_x + y a_y + z a_z - o a, is off by at most seven roundings of
	// the sum of its terms' magnitudes: three a product (of the axis, of the coordinate, its own), three of the sums,
	// one of o a.
	PointHeights(const Vec3& axis, const Vec3& origin, const Box& bounds)
	    : axis_{FourFloats(static_cast<float>(axis.x)), FourFloats(static_cast<float>(axis.y)),
	            FourFloats(static_cast<float>(axis.z))},
	      offset_(static_cast<float>(glm::dot(axis, origin)))
	{
		const Vec3 reach = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi)) + glm::abs(origin);
		constexpr double kRounding = 0x1p-24;
		constexpr double kUnderflow = 0x1p-100; // float has fewer digits there
		constexpr double kFarthest = 1e30;      // beyond it sums may overflow, and everything is in doubt
		doubt_ = std::max({reach.x, reach.y, reach.z}) < kFarthest
		             ? static_cast<float>(kUnderflow + 8.0 * kRounding * glm::dot(glm::abs(axis), reach))
		             : std::numeric_limits<float>::quiet_NaN();
	}

	FourFloats at(const FourPoints& points) const
	{
		return points.x * axis_[0] + points.y * axis_[1] + points.z * axis_[2] - offset_;
	}
	float doubt() const { return doubt_; } // not a number where floats are of no use: no height is at least that

private:
	FourFloats axis_[3];
	FourFloats offset_;
	float doubt_;
};

} // namespace vp::surface
