#pragma once

#include "raw_grid.h"

namespace vp::test
{

// Two lattices that meet at a layer of faces, the same for a seed: 1:1, or several small faces on each large one. They
// are images, rectilinear or curvilinear grids, hexahedra or tetrahedra, each with points of its own, perhaps each
// cell, in blocks of their own or in one. The faces between them are flat, or warped.
RawSet contactSet(unsigned seed);

} // namespace vp::test
