#pragma once

#include "base/vec.h"
#include "shared/classify_types.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace vp::classify
{

// Points in three signed numbers of 41 bits about the middle of their bounds: one texel of sixteen bytes, where
// doubles take two. The unit is a power of two, and 2^-40 of the half size at most: 3e-11 in a domain of 30, with
// near-wall cells of 1e-6. A coordinate that a multiple of the unit does not hit exactly is flagged.
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
			// The shader holds the unit in a float.
			unit_[axis] = std::ldexp(1.0, std::max(exponent - (kBits - 2), -126));
			// On a multiple of the unit, so that round coordinates stay exact; past 2^52 units every double is one.
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
			// The shader's own expression.
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
