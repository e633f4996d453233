#pragma once

#include "surface/curved.h"

#include <optional>

namespace vp::surface
{

/// Returns the surface for the device. Returns nothing if the CPU must classify it: iso values, and expressions that a
/// driver would take long to compile.
std::optional<Curved> gpuSurfaceOf(const BlockSurface& surface);

} // namespace vp::surface
