#pragma once

#include "base/array.h"
#include "base/prefetch.h"
#include "base/vec.h"

#include <cstddef>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace vp::grid
{

/// Returns the point whose coordinates are x, y, z at `xyz`.
inline Vec3 loadPoint(const double* xyz)
{
	return {xyz[0], xyz[1], xyz[2]};
}
inline Vec3 loadPoint(const float* xyz)
{
#ifdef __SSE2__
	// The scalar conversion keeps the upper half of its register, and so waits for whoever wrote that.
	const auto convert = [](const float* number) { return _mm_cvtsd_f64(_mm_cvtps_pd(_mm_load_ss(number))); };
	return {convert(xyz), convert(xyz + 1), convert(xyz + 2)};
#else
	return {xyz[0], xyz[1], xyz[2]};
#endif
}

// Coordinates x, y, z of points, stored as float or double as they came. So no precision is lost and no memory wasted.
class Points
{
public:
	Points() = default;
	explicit Points(Array<float> xyz) : float_(std::move(xyz)), count_(float_.size() / 3) {}
	explicit Points(Array<double> xyz) : double_(std::move(xyz)), count_(double_.size() / 3), is_double_(true) {}

	std::size_t size() const { return count_; }
	bool isDouble() const { return is_double_; }
	std::size_t bytes() const { return float_.size() * sizeof(float) + double_.size() * sizeof(double); }
	// Return the stored numbers, starting with x y z of the first point, or null if they have the other type.
	const float* floats() const { return is_double_ ? nullptr : float_.data(); }
	const double* doubles() const { return is_double_ ? double_.data() : nullptr; }
	const std::shared_ptr<const void>& owner() const { return is_double_ ? double_.owner() : float_.owner(); }
	template <class Number>
	const Number* numbers() const
	{
		if constexpr (std::is_same_v<Number, float>)
			return floats();
		else
			return doubles();
	}
	Vec3 operator[](std::size_t i) const
	{
		// This branch goes the same way during a whole cut, and costs little beside the cache miss.
		if (is_double_)
			return loadPoint(&double_[3 * i]);
		return loadPoint(&float_[3 * i]);
	}
	// Fetches a point before its use.
	void prefetch(std::size_t i) const
	{
		if (is_double_)
			vp::prefetch(&double_[3 * i]);
		else
			vp::prefetch(&float_[3 * i]);
	}
	// The same for the points `from` to `to`.
	void prefetch(std::size_t from, std::size_t to) const
	{
		const std::size_t size = 3 * (is_double_ ? sizeof(double) : sizeof(float));
		const char* base =
		    is_double_ ? reinterpret_cast<const char*>(double_.data()) : reinterpret_cast<const char*>(float_.data());
		constexpr std::size_t kLine = 64;
		for (const char* at = base + from * size; at < base + (to + 1) * size; at += kLine)
			vp::prefetch(at);
		vp::prefetch(base + (to + 1) * size - 1);
	}

private:
	Array<float> float_;
	Array<double> double_;
	std::size_t count_ = 0;
	bool is_double_ = false;
};

} // namespace vp::grid
