#pragma once

#include "grid/block.h"

#include <vector>

namespace vp::render
{

/// Of all unstructured blocks of a set together: the farthest point from the middle in each of some 6000 directions.
/// Their hull is that of all points, but for what no picture shows. Neighbors need not be known, and make no
/// difference. On all cores, the same points for any number of threads.
std::vector<Vec3> farthestPoints(const grid::BlockSet& blocks);

} // namespace vp::render
