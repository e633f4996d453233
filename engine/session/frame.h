#pragma once

#include "session/grown_contours.h"

#include <vector>

namespace vp::session
{

// The result of Session::frame(): the cut of every sheet, its polygons and figures, and contours.
struct Frame
{
	cut::Cut slice;
	std::vector<SheetStats> sheets;
	Contours contours{};         // filled if the settings ask for them
	view::ContourSpec contour{}; // the settings of the contours
	FrameRequest made_for{};     // without the frame before it
	Session::Stamp stamp{};      // of the session that made it
};

} // namespace vp::session
