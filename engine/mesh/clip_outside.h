#pragma once

#include "base/raw_vector.h"
#include "mesh/clip.h"

#include <cstdint>
#include <span>

namespace vp::mesh
{

// Sets for each vertex a bit for each side that it lies outside of. Returns whether there are any.
bool findOutside(const Vec3& origin, std::span<const ClipSide> sides, std::span<const Vec3> positions,
                 RawVector<std::uint8_t>& outside);

} // namespace vp::mesh
