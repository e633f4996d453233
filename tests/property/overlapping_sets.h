#pragma once

#include "exhaustive.h"
#include "raw_grid.h"

#include <vector>

namespace vp::test
{

// Sets whose cells overlap, or lie with a part of a face on a part of another: octrees that keep parents beside their
// children, cells given twice, blocks of two resolutions at one place, large cells on small ones, contact of meshes
// that do not match. With shared points, and with points of each cell's own. In a cube from 0 to 4.
std::vector<RawSet> overlappingSets();

// Planes along the axes through the points of these sets and between them, and some in any direction.
std::vector<TestPlane> planesOfOverlappingSets();

} // namespace vp::test
