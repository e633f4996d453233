#pragma once

#include "session/grown_contours.h"

#include <stop_token>
#include <vector>

namespace vp::session
{

// A frame of a sweep, or of a window, that has been cut.
struct CutFrame
{
	cut::Cut slice;
	std::vector<SheetStats> sheets;
	Contours contours{}; // where they are grown once for the frame
};

/// The session's cut with all that is known of it: warnings are told, figures and contours are there.
Result<CutFrame> cutFrame(const Session& session, std::stop_token stop = {});

// What a slice's sheets show: all figures where they are wanted, else what a picture needs. last: the frame before, by
// the same wish, or null; a sheet that has not moved since shows what it showed.
Result<std::vector<SheetStats>> statsSince(const Session& session, const cut::Cut& slice, const CutFrame* last,
                                           bool wants_figures);

} // namespace vp::session
