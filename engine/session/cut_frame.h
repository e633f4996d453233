#pragma once

#include "session/grown_contours.h"

#include <stop_token>
#include <vector>

namespace vp::session
{

// A frame of a sweep or of a window, after the cut.
struct CutFrame
{
	cut::Cut slice;
	std::vector<SheetStats> sheets;
	Contours contours{}; // filled if contours were asked for
};

/// Cuts, measures and grows contours by the session's settings, and reports warnings.
Result<CutFrame> cutFrame(const Session& session, std::stop_token stop = {});

// Returns what the sheets of a cut show: all figures if `wants_figures`, otherwise what a picture needs. last: the
// frame before, made with the same settings, or null. A sheet that did not move since then keeps its figures.
Result<std::vector<SheetStats>> statsSince(const Session& session, const cut::Cut& slice, const CutFrame* last,
                                           bool wants_figures);

} // namespace vp::session
