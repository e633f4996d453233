#pragma once

#include "base/result.h"
#include "session/cut_frame.h"

#include <string>

namespace vp::app
{

// Tells before long work whether a team can write polygons to a file of this name.
Status checkWritableTogether(const std::string& path);

// Writes the polygons of all ranks of the session's team. As .pvtp, each rank writes a part of its own; any other file,
// the first one writes. Polygons come sheet by sheet there, and within a sheet by ranks;
// contours behind them in the same way.
Status writeTogether(const session::Session& session, const session::CutFrame& frame, const std::string& path);

} // namespace vp::app
