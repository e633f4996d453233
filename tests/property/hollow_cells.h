#pragma once

#include "raw_grid.h"

namespace vp::test
{

// Cells that are concave or have holes, each as one polyhedron whose faces run either way round, with sides along the
// axes. The holes may be filled by cells of their own.

// A square from 0 to 3 along x and y, 1 high, with a square hole from 1 to 2.
RawSet ringCell(bool filled = false);

// A cube from 0 to 3 around a closed void from 1 to 2.
RawSet shellCell(bool filled = false);

// Arms from x = 0 to 1 and from 2 to 3, up to y = 3, on a foot up to y = 1; 1 high.
RawSet uCell(bool filled = false);

} // namespace vp::test
