#pragma once

#include "grid/block.h"

#include <vector>

namespace vp::render
{

/// Returns for all unstructured blocks of a set together the farthest points from the middle (grid/farthest_points.h).
/// It needs no neighbors.
std::vector<Vec3> farthestPoints(const grid::BlockSet& blocks);

} // namespace vp::render
