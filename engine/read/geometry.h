#pragma once

#include "read/manifest.h"

#include <cstdint>

namespace vp::read
{

// Returns a number that is the same for the same grid. It depends on the kind, the coordinates and the cells, and
// differs for another grid, with a chance of error of 2^-64. It is never 0.
std::uint64_t geometryOf(const CheckedBlock& block);

} // namespace vp::read
