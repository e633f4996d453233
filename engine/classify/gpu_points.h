#pragma once

#include "base/vec.h"
#include "shared/classify_types.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace vp::classify
{

// Points as three signed numbers of 41 bits, relative to the middle of their bounds. They fit into one texel of sixteen
// bytes, while doubles need two. The unit is a power of two and at most 2^-40 of the half size: 3e-11 in a domain of 30
// with cells of 1e-6 at the wall. A coordinate that is not a multiple of the unit is flagged.
class FixedPoints
{
public:
	static constexpr int kBits = 41;

	explicit FixedPoints(const Box& bounds)
	{
		center_ = bounds.center();
		for (int axis = 0; axis < 3; ++axis)
		{
			const double half = 0.5 * bounds.size()[axis];
			int exponent = 0;
			std::frexp(half, &exponent); // half < 2^exponent
			// The unit is a float in the shader.
			unit_[axis] = std::ldexp(1.0, std::max(exponent - (kBits - 2), -126));
			// The center is a multiple of the unit, so that round coordinates stay exact. From 2^52 units on, every
			// double is one.
			if (std::abs(center_[axis] / unit_[axis]) < 0x1p52)
				center_[axis] = std::round(center_[axis] / unit_[axis]) * unit_[axis];
		}
	}

	const Vec3& center() const { return center_; }
	const Vec3& unit() const { return unit_; }

	std::array<std::uint32_t, 4> pack(const Vec3& point) const
	{
		std::array<std::uint32_t, 4> packed{};
		for (int axis = 0; axis < 3; ++axis)
		{
			const std::int64_t number = std::llround((point[axis] - center_[axis]) / unit_[axis]);
			packed[axis] = static_cast<std::uint32_t>(number >> shared::kFixedLowBits);
			const auto low = static_cast<std::uint32_t>(number & ((1 << shared::kFixedLowBits) - 1));
			packed[3] |= low << (shared::kFixedLowBits * axis);
			// The same expression as in the shader.
			const double unpacked = center_[axis] + static_cast<double>(number) * unit_[axis];
			if (unpacked != point[axis])
				packed[3] |= 1u << (shared::kFixedInexactShift + axis);
		}
		return packed;
	}

private:
	Vec3 center_;
	Vec3 unit_;
};

} // namespace vp::classify
