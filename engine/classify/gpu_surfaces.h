#pragma once

#include "base/result.h"
#include "classify/gpu_sheet_in_block.h"
#include "surface/curved.h"

#include <span>
#include <vector>

namespace vp::classify
{

/// A curved surface as the device classifies it, one a block; surfaces: as each block sees it. Only codes come back:
/// the meshes are the CPU's to make. Where the device cannot classify the surface (surface/gpu_surface.h), or does not
/// hold the block, there is no pipeline. Compiles what is needed and not compiled yet.
Result<std::vector<GpuSheetInBlock>> surfaceOnGpu(GpuBlocks& blocks, std::span<const surface::BlockSurface> surfaces);

} // namespace vp::classify
