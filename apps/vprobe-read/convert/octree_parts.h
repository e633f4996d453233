#pragma once

#include "curve_order.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vp::reader::convert
{

// Divides cells in the order of the curve into parts of at most `most` cells, which is at least 1. Parts are cubes of
// an octree, or several of one parent that lie behind each other on the curve. Returns where each part ends.
std::vector<std::size_t> divide(std::span<const CellOnCurve> cells, std::size_t most);

} // namespace vp::reader::convert
