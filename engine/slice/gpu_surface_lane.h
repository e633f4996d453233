#pragma once

#include "shared/surface_types.h"
#include "slice/gpu_lane.h"
#include "surface/expression.h"

#include <array>
#include <optional>

namespace vp::slice
{

// A polynomial of degree 2 in p - origin: the sum of coefficient i times the i-th of 1, x, y, z, xx, yy, zz, xy, yz,
// zx.
struct Polynomial
{
	Vec3 origin;
	std::array<double, shared::kQuadricCoefficients> coefficient;
};

// A curved surface as the device has it: an expression, else a polynomial.
struct GpuSurface
{
	std::optional<surface::Expression> expression;
	Polynomial polynomial{};
};

// What the shader is told about a surface in a block. Fills `axes` (axisTexels() of them), whose first is texel
// `axis_start` of the buffer.
shared::SurfaceLane describeSurfaceLane(const grid::Block& block, const GpuBlock& on_device, const GpuSurface& surface,
                                        std::size_t axis_start, std::span<AxisTexel> axes);

} // namespace vp::slice
