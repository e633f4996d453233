#pragma once

#include "base/result.h"
#include "session/cut_frame.h"

#include <string>

namespace vp::app
{

// Tells before long work whether a team can write polygons to a file of this name: .vtp, .ply and .csv, or none.
Status checkWritableTogether(const std::string& path);

// Writes the polygons of all ranks of the session's team as one file, which the first one writes. They come sheet by
// sheet, and within a sheet by blocks.
Status writeTogether(const session::Session& session, const session::CutFrame& frame, const std::string& path);

} // namespace vp::app
