#pragma once

#include "raw_grid.h"

namespace vp::test
{

// Layers over a wavy wall, 30 x 30 wide, that start 1e-6 thick and grow until they fill 30 units.
RawSet nearWall(const Vec3& offset, bool as_hexahedra = false);

// Warped cells of 0.01 near a corner at 1e7.
RawSet farAway(bool as_hexahedra);

} // namespace vp::test
