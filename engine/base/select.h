#pragma once

#include "base/vec.h"

#include <bit>
#include <cstdint>

namespace vp
{

/// Returns `condition ? a : b` without a branch, for conditions that cannot be foreseen.
inline double select(bool condition, double a, double b)
{
	const std::uint64_t mask = 0 - static_cast<std::uint64_t>(condition);
	return std::bit_cast<double>((std::bit_cast<std::uint64_t>(a) & mask) | (std::bit_cast<std::uint64_t>(b) & ~mask));
}
inline Vec3 select(bool condition, const Vec3& a, const Vec3& b)
{
	return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

} // namespace vp
