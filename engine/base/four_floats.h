#pragma once

#include <array>
#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vp
{

// Four floats, computed in one step by SSE2 or one by one, with the same results. Bit v of a comparison belongs to pair
// v. Comparisons with NaN are false.
class FourFloats
{
public:
#ifdef __SSE2__
	FourFloats(__m128 v) : v_(v) {}
	explicit FourFloats(float all) : v_(_mm_set1_ps(all)) {}

	friend FourFloats operator+(FourFloats a, FourFloats b)
	{
		return _mm_add_ps(a.v_, b.v_);
	}
	friend FourFloats operator-(FourFloats a, FourFloats b)
	{
		return _mm_sub_ps(a.v_, b.v_);
	}
	friend FourFloats operator*(FourFloats a, FourFloats b)
	{
		return _mm_mul_ps(a.v_, b.v_);
	}
	friend FourFloats magnitude(FourFloats a)
	{
		return _mm_andnot_ps(_mm_set1_ps(-0.0f), a.v_);
	}
	friend FourFloats lesser(FourFloats a, FourFloats b)
	{
		return _mm_min_ps(a.v_, b.v_);
	}
	friend FourFloats greater(FourFloats a, FourFloats b)
	{
		return _mm_max_ps(a.v_, b.v_);
	}
	friend unsigned bitsAtLeast(FourFloats a, FourFloats b)
	{
		return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpge_ps(a.v_, b.v_)));
	}
	// Compares four times four numbers. Bit 4 v + r stands for number v of a[r].
	friend unsigned bitsAtLeast(const std::array<FourFloats, 4>& a, FourFloats b)
	{
		const auto mask = [&](int r) { return _mm_castps_si128(_mm_cmpge_ps(a[r].v_, b.v_)); };
		// A byte each, by r, then v; two steps exchange the two.
		__m128i bytes = _mm_packs_epi16(_mm_packs_epi32(mask(0), mask(1)), _mm_packs_epi32(mask(2), mask(3)));
		bytes = _mm_unpacklo_epi8(bytes, _mm_srli_si128(bytes, 8));
		bytes = _mm_unpacklo_epi8(bytes, _mm_srli_si128(bytes, 8));
		return static_cast<unsigned>(_mm_movemask_epi8(bytes));
	}

private:
	__m128 v_;
#else
	FourFloats(const std::array<float, 4>& v) : v_(v) {}
	explicit FourFloats(float all) : v_{all, all, all, all} {}

	friend FourFloats operator+(FourFloats a, FourFloats b)
	{
		return a.with(b, [](float x, float y) { return x + y; });
	}
	friend FourFloats operator-(FourFloats a, FourFloats b)
	{
		return a.with(b, [](float x, float y) { return x - y; });
	}
	friend FourFloats operator*(FourFloats a, FourFloats b)
	{
		return a.with(b, [](float x, float y) { return x * y; });
	}
	friend FourFloats magnitude(FourFloats a)
	{
		return a.with(a, [](float x, float) { return std::abs(x); });
	}
	friend FourFloats lesser(FourFloats a, FourFloats b)
	{
		return a.with(b, [](float x, float y) { return x < y ? x : y; });
	}
	friend FourFloats greater(FourFloats a, FourFloats b)
	{
		return a.with(b, [](float x, float y) { return x > y ? x : y; });
	}
	friend unsigned bitsAtLeast(FourFloats a, FourFloats b)
	{
		unsigned bits = 0;
		for (unsigned v = 0; v < 4; ++v)
			bits |= static_cast<unsigned>(a.v_[v] >= b.v_[v]) << v;
		return bits;
	}
	friend unsigned bitsAtLeast(const std::array<FourFloats, 4>& a, FourFloats b)
	{
		unsigned bits = 0;
		for (unsigned r = 0; r < 4; ++r)
			for (unsigned v = 0; v < 4; ++v)
				bits |= static_cast<unsigned>(a[r].v_[v] >= b.v_[v]) << (4 * v + r);
		return bits;
	}

private:
	template <class Operation>
	FourFloats with(const FourFloats& b, Operation&& operation) const
	{
		return std::array{operation(v_[0], b.v_[0]), operation(v_[1], b.v_[1]), operation(v_[2], b.v_[2]),
		                  operation(v_[3], b.v_[3])};
	}

	std::array<float, 4> v_;
#endif
};

} // namespace vp
