#pragma once

#include "grid/field.h"

#include <cstddef>

namespace vp::reader::convert
{

class PackDivision;

// Writes floats that tell between which values those of the points of each run of a part lie: for each component, and
// for the length of a tuple if there are several, the least and the greatest finite one, rounded outwards. `values`
// are those of the points of the grid.
void gatherRanges(const PackDivision& division, std::size_t part, const grid::Field& values, std::byte* to);

} // namespace vp::reader::convert
