#pragma once

#include "base/ids.h"
#include "grid/points.h"
#include "surface/plane.h"
#include "traverse/sign_filter.h"

namespace vp::traverse
{

// S at runs of points, four at a time, the same bits as isPositive(). Number is what the coordinates are kept as.
template <class Number>
class RowSigns
{
public:
	// bounds: of the points.
	RowSigns(const grid::Points& points, const surface::Plane& plane, const Box& bounds);

	// Bit v: S at point p + v, for v < count <= 4. Bits from count on are 0.
	unsigned few(PointId p, unsigned count) const
	{
		unsigned bits = 0;
		for (unsigned v = 0; v < count; ++v)
			bits |= static_cast<unsigned>(plane_.signedDistance(points_[p + v]) >= 0.0) << v;
		return bits;
	}
	// Of the points p to p + 3, which all exist.
	unsigned four(PointId p) const { return few(p, 4); }

	void prefetch(PointId from, PointId to) const { points_.prefetch(from, to); }

private:
	const grid::Points& points_;
	const surface::Plane& plane_;
	const Number* xyz_;
	SignFilter filter_;
};

template <class Number>
RowSigns<Number>::RowSigns(const grid::Points& points, const surface::Plane& plane, const Box& bounds)
    : points_(points), plane_(plane), filter_(plane, bounds)
{
	if constexpr (std::is_same_v<Number, float>)
		xyz_ = points.floats();
	else
		xyz_ = points.doubles();
}

#ifdef __SSE2__
template <>
inline unsigned RowSigns<float>::four(PointId p) const
{
	const float* at = xyz_ + 3 * std::size_t(p);
	const __m128 a = _mm_loadu_ps(at);     // x0 y0 z0 x1
	const __m128 b = _mm_loadu_ps(at + 4); // y1 z1 x2 y2
	const __m128 c = _mm_loadu_ps(at + 8); // z2 x3 y3 z3
	const __m128 x2y2x3y3 = _mm_shuffle_ps(b, c, _MM_SHUFFLE(2, 1, 3, 2));
	const __m128 y0z0y1z1 = _mm_shuffle_ps(a, b, _MM_SHUFFLE(1, 0, 2, 1));
	const __m128 x = _mm_shuffle_ps(a, x2y2x3y3, _MM_SHUFFLE(2, 0, 3, 0));
	const __m128 y = _mm_shuffle_ps(y0z0y1z1, x2y2x3y3, _MM_SHUFFLE(3, 1, 2, 0));
	const __m128 z = _mm_shuffle_ps(y0z0y1z1, c, _MM_SHUFFLE(3, 0, 3, 1));
	const unsigned bits = filter_.four(x, y, z);
	return bits == SignFilter::kInDoubt ? few(p, 4) : bits;
}
#endif

} // namespace vp::traverse
