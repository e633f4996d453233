#pragma once

#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vp
{

// Two doubles, computed in one step where the processor can: the compiler knows how. Comparisons give masks, all
// bits set where they hold, and `mask ? a : b` selects lane by lane.
using TwoDoubles = double __attribute__((vector_size(16)));

inline TwoDoubles bothOf(double value)
{
	return TwoDoubles{value, value};
}

// The two numbers at an address.
inline TwoDoubles loadTwo(const double* from)
{
	TwoDoubles two;
	std::memcpy(&two, from, sizeof(two));
	return two;
}
inline TwoDoubles loadTwo(const float* from)
{
#ifdef __SSE2__
	double bits;
	std::memcpy(&bits, from, sizeof(bits));
	return _mm_cvtps_pd(_mm_castpd_ps(_mm_set_sd(bits)));
#else
	return TwoDoubles{from[0], from[1]};
#endif
}

// Numbers from two places.
inline TwoDoubles loadTwo(const double* first, const double* second)
{
	return TwoDoubles{*first, *second};
}
inline TwoDoubles loadTwo(const float* first, const float* second)
{
#ifdef __SSE2__
	return _mm_cvtps_pd(_mm_unpacklo_ps(_mm_load_ss(first), _mm_load_ss(second)));
#else
	return TwoDoubles{*first, *second};
#endif
}

inline void storeTwo(double* to, TwoDoubles two)
{
	std::memcpy(to, &two, sizeof(two));
}

// The first, or the second, of each.
template <class Two>
Two firstsOf(Two a, Two b)
{
	return __builtin_shufflevector(a, b, 0, 2);
}
template <class Two>
Two secondsOf(Two a, Two b)
{
	return __builtin_shufflevector(a, b, 1, 3);
}

inline TwoDoubles swapped(TwoDoubles a)
{
	return __builtin_shufflevector(a, a, 1, 0);
}

inline TwoDoubles greater(TwoDoubles a, TwoDoubles b)
{
#ifdef __SSE2__
	return _mm_max_pd(a, b);
#else
	return a > b ? a : b;
#endif
}
inline TwoDoubles lesser(TwoDoubles a, TwoDoubles b)
{
#ifdef __SSE2__
	return _mm_min_pd(a, b);
#else
	return a < b ? a : b;
#endif
}

inline bool isAnyEqual(TwoDoubles a, TwoDoubles b)
{
#ifdef __SSE2__
	return _mm_movemask_pd(_mm_cmpeq_pd(a, b)) != 0;
#else
	return a[0] == b[0] || a[1] == b[1];
#endif
}

} // namespace vp
