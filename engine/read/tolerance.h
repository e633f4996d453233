#pragma once

namespace vp::read
{

// Rounding would be seen below this.
constexpr double kMinTolerance = 1e-6;

// Returns true if the setting `refine` is no level but a share of a cell's size and of an array's range: between 0
// and 1.
constexpr bool isTolerance(double refine)
{
	return refine > 0.0 && refine < 1.0;
}

} // namespace vp::read
