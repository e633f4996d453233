#pragma once

#include "exhaustive.h"
#include "raw_grid.h"

namespace vp::test
{

// A block set of random kind, shape, size, proportions and place, the same for a seed: images, rectilinear and
// curvilinear grids (warped, folded, left-handed, closed to a ring, with a collapsed axis), cells of every shape and
// mixes of them, polyhedra, blanked and degenerate cells, several blocks. Anisotropy up to 1e6, offsets up to 1e7.
RawSet randomSet(unsigned seed);

// A plane that is of interest to the set: anywhere, through vertices, edges, faces and layers, along the axes, on the
// boundary from either side, beside the set.
TestPlane randomPlane(const grid::BlockSet& set, unsigned seed);

} // namespace vp::test
