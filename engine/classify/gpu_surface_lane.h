#pragma once

#include "classify/gpu_lane.h"
#include "shared/surface_types.h"
#include "surface/curved.h"

#include <span>

namespace vp::classify
{

// What the shader is told about a surface in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::SurfaceLane describeSurfaceLane(const grid::Block& block, const GpuBlock& on_device,
                                        const surface::Curved& surface, std::size_t axis_start,
                                        std::span<AxisTexel> axes);

} // namespace vp::classify
