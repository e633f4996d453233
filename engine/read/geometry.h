#pragma once

#include "read/manifest.h"

#include <cstdint>

namespace vp::read
{

// A number that is the same for the same grid and, with a chance of error of 2^-64, for no other: of the mesh's kind,
// coordinates and cells. Never 0.
std::uint64_t geometryOf(const CheckedBlock& block);

} // namespace vp::read
