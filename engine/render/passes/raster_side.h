#pragma once

#include "base/result.h"

#include <cstdint>

namespace vp::gpu
{
class Device;
}

namespace vp::render
{

// The side of polygons, in pixels, up to which the compute rasterizer is to draw them.
//
// Measured with llvmpipe: squares of 12 pixels a side take 4.6 ms a picture with the compute shader and 6.6 with its
// own rasterizer, of 16 pixels 5.5 and 5.3, of 4 pixels 5.1 and 24.
constexpr std::uint32_t kRasterSide = 16;

// kRasterSide, or 0 where the device's own rasterizer is the faster one. That is known of software, and measured
// elsewhere.
Result<std::uint32_t> suitableRasterSide(gpu::Device& device);

// Measures it: a page of squares of two pixels a side, each way a few times. 30 MB on the device while it runs.
Result<std::uint32_t> measuredRasterSide(gpu::Device& device);

} // namespace vp::render
