#pragma once

#include "surface/curved.h"

#include <optional>

namespace vp::surface
{

/// The surface, where the device can classify it: values are the CPU's, and so are expressions that a driver would take
/// long to compile.
std::optional<Curved> gpuSurfaceOf(const BlockSurface& surface);

} // namespace vp::surface
