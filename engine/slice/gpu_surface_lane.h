#pragma once

#include "shared/surface_types.h"
#include "slice/gpu_lane.h"
#include "surface/curved.h"

#include <optional>
#include <span>

namespace vp::slice
{

// The surface, where the device can classify it: values are the CPU's, and so are expressions that a driver would take
// long to compile.
std::optional<surface::Curved> gpuSurfaceOf(const surface::BlockSurface& surface);

// What the shader is told about a surface in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::SurfaceLane describeSurfaceLane(const grid::Block& block, const GpuBlock& on_device,
                                        const surface::Curved& surface, std::size_t axis_start,
                                        std::span<AxisTexel> axes);

} // namespace vp::slice
