#pragma once

#include "probe/sheet.h"
#include "shared/classify_types.h"
#include "slice/gpu_blocks.h"

#include <array>
#include <cstdint>
#include <span>

namespace vp::slice
{

using AxisTexel = std::array<std::uint32_t, 4>;

// The texels that the axes of an image or rectilinear grid take; 0 for other grids.
std::size_t axisTexels(const grid::AnyGrid& grid);

// What the shader is told about a sheet in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::ClassifyLane describeLane(const grid::Block& block, const GpuBlock& on_device, const GpuValues& values,
                                  bool field_chosen, bool doubles, const probe::Sheet& sheet, std::size_t axis_start,
                                  std::span<AxisTexel> axes);

} // namespace vp::slice
