#pragma once

#include "base/result.h"
#include "grid/block.h"

#include <cstddef>
#include <optional>

namespace vp::gpu
{
class Device;
}

namespace vp::classify
{

// From how many cells on a front is classified faster by a device than by a thread of the CPU; none where it never is,
// as on software devices, which share the CPU's cores.
struct BreakEven
{
	std::optional<std::size_t> cells;
};

// Measured: fronts of several widths are classified by both, on cells from the middle of the largest block. What the
// device does on top, writing polygons, is to its disadvantage. Takes some 20 ms besides what the driver needs to make
// a pipeline; nothing of it is kept. An error where the device is lost.
Result<BreakEven> measureBreakEven(gpu::Device& device, const grid::BlockSet& blocks);

} // namespace vp::classify
