#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace vp::reader::vtk
{

// Checks of what a pack says of its cells. All throw a Refusal.

// ids: of points of their part, which has so many. first: the id of its first point.
void refuseWrongIds(std::span<const std::int32_t> ids, std::uint64_t first, std::size_t points);

// A cut goes by the boxes, so points that were moved by hand would lose cells without a word. places: from that of the
// point 0 on, three numbers each. box: lo and hi.
void refuseOutside(std::span<const std::int32_t> ids, const float* places, const std::array<double, 6>& box);
void refuseOutside(std::span<const std::int32_t> ids, const double* places, const std::array<double, 6>& box);

// ends: of cells that have so many ids together, and before them the end of the cell before.
void refuseWrongEnds(std::span<const std::int32_t> ends, std::uint64_t ids);

} // namespace vp::reader::vtk
