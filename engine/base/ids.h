#pragma once

#include <cstdint>

namespace vp
{

// Cells and points are numbered within their block. 32 bits halve what the traversal moves; the reader refuses a block
// that does not fit.
using CellId = std::uint32_t;
using PointId = std::uint32_t;

constexpr CellId kNoCell = 0xFFFFFFFFu;

// Ids from here up are marks (see grid/unstructured.h), so a block holds at most this many cells or points.
constexpr std::uint32_t kMaxBlockIds = 0xC0000000u;

} // namespace vp
