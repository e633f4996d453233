#pragma once

#include "base/result.h"
#include "path_options.h"
#include "probe_options.h"
#include "surface/grid_index.h"

#include <optional>

namespace vp::app
{

// What --surface says, none where it is not given. A usage error where it cannot be, or beside an option that places a
// plane.
Result<std::optional<surface::GridIndexRange>> surfaceOf(const ProbeOptions& options);

// Of commands that show one surface: a usage error where a range is given.
Status requireOneSurface(const ProbeOptions& options);

// Of a sweep: a usage error where the path is none for a surface.
Status requirePathOfSurface(const ProbeOptions& options, const PathOptions& path);

} // namespace vp::app
