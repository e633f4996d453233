#pragma once

#include "shared/surface_types.h"
#include "slice/gpu_lane.h"
#include "surface/curved.h"
#include "surface/expression.h"

#include <optional>
#include <span>
#include <variant>

namespace vp::slice
{

// An expression of the world's coordinates, or of those in a frame.
struct GpuExpression
{
	surface::Expression expression;
	std::optional<surface::Axes> axes = {};
};

// A curved surface that the device can classify.
using GpuSurface = std::variant<surface::Quadric, GpuExpression>;

// None of values, which the CPU has.
std::optional<GpuSurface> gpuSurfaceOf(const surface::BlockSurface& surface);

// What the shader is told about a surface in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::SurfaceLane describeSurfaceLane(const grid::Block& block, const GpuBlock& on_device, const GpuSurface& surface,
                                        std::size_t axis_start, std::span<AxisTexel> axes);

} // namespace vp::slice
