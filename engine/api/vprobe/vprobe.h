#pragma once

/// Volume Probes as a library: cuts of volume data on any grid, after Speray and Kennon (1990). docs/EMBEDDING.md shows
/// its use.

#include <vprobe/cut.h>
#include <vprobe/dataset.h>
#include <vprobe/image.h>
#include <vprobe/result.h>
#include <vprobe/view.h>

namespace vprobe
{

/// "0.1.0"
VPROBE_API const char* version();

} // namespace vprobe
