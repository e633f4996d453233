#pragma once

#include "stats_json.h"

#include <vector>

namespace vp::app
{

// A frame of a sweep, or of a window, that has been cut.
struct CutFrame
{
	slice::Slice slice;
	std::vector<SheetStats> sheets;
};

// Figures of a slice. last: the frame before, or null; a sheet that has not moved since shows what it showed.
std::vector<SheetStats> statsSince(const Session& session, const slice::Slice& slice, const CutFrame* last);

} // namespace vp::app
