#pragma once

#include "base/result.h"
#include "session/frame.h"
#include "write/line_file.h"
#include "write/slice_table.h"

#include <cstddef>
#include <string>

namespace vp::app
{

// Tells before long work whether a team can write polygons to a file of this name.
Status checkWritableTogether(const std::string& path);

// Returns the polygons of a frame as one table; with a team, at the first rank those of all ranks, in the order of
// writeTogether(), and at others a part. All ranks call this together.
write::SliceTable tableOf(const session::Session& session, const session::Frame& frame);

// The same of one sheet, and of the polygons that a line may meet alone.
write::SliceTable tableAlong(const session::Session& session, const session::Frame& frame, std::size_t sheet,
                             const write::SheetLine& line);

// Writes the polygons of all ranks of the session's team. As .pvtp, each rank writes a part of its own; any other file,
// the first one writes. Polygons come sheet by sheet there, and within a sheet by ranks;
// contours behind them in the same way.
Status writeTogether(const session::Session& session, const session::Frame& frame, const std::string& path);

} // namespace vp::app
