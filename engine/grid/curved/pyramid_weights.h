#pragma once

#include "base/vec.h"

#include <array>
#include <span>

namespace vp::grid
{

// Pyramids over the unit square with their top at (1/2, 1/2, 1). Their shape functions are rational: Bedrosian's
// ("Shape functions and integration formulas for three-dimensional finite element analysis", 1992), which hold all
// quadratic polynomials. VTK's do not. Corners are in VTK's order, then the middles of the edges of the base, then of
// those to the top.

/// The signs of x and y at the corners of the base, where that runs from -1 to 1.
inline constexpr std::array<std::array<int, 2>, 4> kPyramidSigns = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// Writes the shape functions of 5 or of 13 nodes.
void weighPyramid(const Vec3& at, std::span<double> weights);

} // namespace vp::grid
