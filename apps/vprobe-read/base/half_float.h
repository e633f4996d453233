#pragma once

#include <cmath>
#include <cstdint>

namespace vp::reader
{

// Returns the number that 16 bits write in IEEE's half precision.
inline float fromHalf(std::uint16_t bits)
{
	const int exponent = bits >> 10 & 0x1F;
	const int fraction = bits & 0x3FF;
	const float size = exponent == 0x1F ? (fraction ? NAN : INFINITY)
	                   : exponent == 0  ? std::ldexp(static_cast<float>(fraction), -24)
	                                    : std::ldexp(static_cast<float>(fraction + 0x400), exponent - 25);
	return bits >> 15 ? -size : size;
}

} // namespace vp::reader
