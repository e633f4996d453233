#pragma once

#include "base/vec.h"

#include <bit>
#include <cstdint>

namespace vp
{

// Returns a number that is the same for the same place. Different places hardly ever have the same key, but callers
// must compare them.
inline std::uint64_t placeKey(const Vec3& place)
{
	std::uint64_t key = 0;
	for (int axis = 0; axis < 3; ++axis)
		key = std::rotl(key, 21) * 0x9E3779B97F4A7C15ull + std::bit_cast<std::uint64_t>(place[axis] + 0.0); // no -0
	return key;
}

} // namespace vp
