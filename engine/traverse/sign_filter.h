#pragma once

#include "base/vec.h"
#include "surface/plane.h"

#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vp::traverse
{

// S at points kept as float, four at a time and in float, where that is certain to be what the one expression in double
// says (Plane::signedDistance).
//
// The distance in float, as x n_x + y n_y + z n_z - o n, is off by at most six roundings of the sum of its terms'
// magnitudes: two a product (the normal's and its own), three of the sums, one of o n.
class SignFilter
{
public:
	static constexpr unsigned kInDoubt = ~0u;

	// bounds: of the points.
	SignFilter(const surface::Plane& plane, const Box& bounds)
	    : offset_(static_cast<float>(glm::dot(plane.normal(), plane.origin())))
	{
		for (int axis = 0; axis < 3; ++axis)
			normal_[axis] = static_cast<float>(plane.normal()[axis]);
		const Vec3 reach = glm::max(glm::abs(bounds.lo), glm::abs(bounds.hi));
		constexpr double kRounding = 0x1p-24;
		constexpr double kUnderflow = 0x1p-100; // float has fewer digits there
		doubt_ = static_cast<float>(
		    kUnderflow + 8.0 * kRounding * glm::dot(glm::abs(plane.normal()), reach + glm::abs(plane.origin())));
	}

#ifdef __SSE2__
	// Bit v: S at the point of x[v], y[v], z[v]. kInDoubt where one of them is to be asked in double.
	unsigned four(__m128 x, __m128 y, __m128 z) const
	{
		const __m128 sum =
		    _mm_add_ps(_mm_add_ps(_mm_mul_ps(x, _mm_set1_ps(normal_[0])), _mm_mul_ps(y, _mm_set1_ps(normal_[1]))),
		               _mm_mul_ps(z, _mm_set1_ps(normal_[2])));
		const __m128 distance = _mm_sub_ps(sum, _mm_set1_ps(offset_));
		const __m128 magnitude = _mm_andnot_ps(_mm_set1_ps(-0.0f), distance);
		// Where the distance is not a number, it is in doubt too.
		if (_mm_movemask_ps(_mm_cmpngt_ps(magnitude, _mm_set1_ps(doubt_))) != 0)
			return kInDoubt;
		return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpge_ps(distance, _mm_setzero_ps())));
	}
#endif

private:
	float normal_[3];
	float offset_;
	float doubt_; // a distance in float is wrong by less than this
};

} // namespace vp::traverse
