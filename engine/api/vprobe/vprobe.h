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

/// Ends the library's threads that wait for work; the next call starts others. Call it before the process forks, while
/// nothing of the library is at work: the child can cut then. It cannot use a Vulkan device that the parent opened.
/// Returns false, and ends none, if another thread that has called the library still lives.
VPROBE_API bool endIdleThreads();

} // namespace vprobe
