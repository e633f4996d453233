#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace vp::reader::convert
{

// The place of a cell along a Morton curve (21 bits an axis, x the lowest), and its number.
using CellOnCurve = std::pair<std::uint64_t, std::uint32_t>;

// A bit of each axis in turn. Each axis is from 0 to 2^21 - 1.
std::uint64_t mortonKey(std::uint32_t x, std::uint32_t y, std::uint32_t z);

// Sorts cells along the curve, and divides them into parts of at most `most` cells, which is at least 1. Parts are
// cubes of an octree, or several of one parent that lie behind each other on the curve. Returns where each part ends.
std::vector<std::size_t> divide(std::vector<CellOnCurve>& cells, std::size_t most, int threads);

} // namespace vp::reader::convert
