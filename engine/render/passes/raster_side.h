#pragma once

#include "base/result.h"
#include "shared/render_types.h"

#include <cstdint>

namespace vp::gpu
{
class Device;
}

namespace vp::render
{

// The side of polygons, in pixels, up to which one thread of the compute rasterizer draws a polygon. Threads of
// software that run in step have polygons of about one size, as neighbors are; a hardware device would wait for its
// slowest thread. Measured with llvmpipe (tests/bench/draw_bench.cpp): a picture of squares of 24 pixels takes 1.7 ms
// with 64, 2.3 with 32 and 2.4 with 16; of rectangles of 20 x 0.2 pixels 10, 9.4 and 36.
constexpr std::uint32_t kRasterSide = 16;
constexpr std::uint32_t kSoftwareRasterSide = shared::kMaxRasterSide;

// One of both, or 0 where the device's own rasterizer is the faster one. That is known of software, and measured
// elsewhere.
Result<std::uint32_t> suitableRasterSide(gpu::Device& device);

// Measures it: a page of squares of two pixels a side, each way a few times. 30 MB on the device while it runs.
Result<std::uint32_t> measuredRasterSide(gpu::Device& device);

} // namespace vp::render
