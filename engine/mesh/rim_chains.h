#pragma once

#include "base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::mesh
{

/// A straight side cuts a polygon that is not convex, and leaves several chains of its corners: each from where the
/// polygon comes in to where it goes out. Joins them along the side, where polygons with an area are between, into the
/// polygons that are left. positions: of the mesh's vertices.
std::vector<std::vector<std::uint32_t>> joinAlongRim(std::span<const std::vector<std::uint32_t>> chains,
                                                     const Vec3* positions);

} // namespace vp::mesh
