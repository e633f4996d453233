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

// Returns the number of cells from which a device classifies a front faster than one thread of the CPU. Returns nothing
// if it never does, as for software devices, which share the cores of the CPU.
struct BreakEven
{
	std::optional<std::size_t> cells;
};

// It measures: both classify fronts of several widths, with cells from the middle of the largest block. The device also
// writes polygons, which counts against it. This takes some 20 ms, and the time that the driver needs to make a
// pipeline. Nothing is kept. Returns an error if the device is lost.
Result<BreakEven> measureBreakEven(gpu::Device& device, const grid::BlockSet& blocks);

} // namespace vp::classify
