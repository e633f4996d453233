#pragma once

#include "grid/record_reader.h"
#include "traverse/sign_filter.h"

namespace vp::traverse
{

// S at the points of a cell's record, the same bits as isPositive().
template <int kWidth, class Number>
class RecordSigns
{
public:
	using Reader = grid::RecordReader<kWidth, Number>;

	// bounds: of the points.
	RecordSigns(const Reader& reader, const surface::Plane& plane, const Box& bounds)
	    : reader_(reader), plane_(plane), filter_(plane, bounds)
	{
	}

	// Bit v: S at point v of the cell, which is of a table shape.
	unsigned of(const std::uint32_t* record, grid::CellShape shape) const
	{
#ifdef __SSE2__
		if constexpr (std::is_same_v<Number, float>)
		{
			const unsigned low = four(record[0], record[1], record[2], record[3]);
			if constexpr (kWidth == 4)
				return low != SignFilter::kInDoubt ? low : inDouble(record, 4);
			// A shape of fewer points has ids to spare, but for the last one, which is a mark.
			const bool full = shape == grid::CellShape::hexahedron;
			const unsigned high = four(record[4], record[5], record[6], full ? record[7] : record[6]);
			if (low != SignFilter::kInDoubt && high != SignFilter::kInDoubt)
				return (low | high << 4) & ((1u << grid::topology(shape).points) - 1);
		}
#endif
		return inDouble(record, grid::topology(shape).points);
	}

private:
	unsigned inDouble(const std::uint32_t* record, int points) const
	{
		unsigned bits = 0;
		for (int v = 0; v < points; ++v)
			bits |= static_cast<unsigned>(plane_.signedDistance(reader_.point(record[v])) >= 0.0) << v;
		return bits;
	}

#ifdef __SSE2__
	unsigned four(PointId a, PointId b, PointId c, PointId d) const
	{
		const float* p[] = {reader_.xyz(a), reader_.xyz(b), reader_.xyz(c), reader_.xyz(d)};
		const __m128 xy01 = xyOfTwo(p[0], p[1]);
		const __m128 xy23 = xyOfTwo(p[2], p[3]);
		const __m128 x = _mm_shuffle_ps(xy01, xy23, _MM_SHUFFLE(2, 0, 2, 0));
		const __m128 y = _mm_shuffle_ps(xy01, xy23, _MM_SHUFFLE(3, 1, 3, 1));
		return filter_.four(x, y, _mm_set_ps(p[3][2], p[2][2], p[1][2], p[0][2]));
	}

	static __m128 xyOfTwo(const float* p, const float* q)
	{
		const __m128 first = _mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(p));
		return _mm_loadh_pi(first, reinterpret_cast<const __m64*>(q));
	}
#endif

	const Reader& reader_;
	const surface::Plane& plane_;
	SignFilter filter_;
};

} // namespace vp::traverse
