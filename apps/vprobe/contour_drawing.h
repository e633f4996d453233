#pragma once

#include "grown_contours.h"
#include "look_options.h"

namespace vp::app
{

// Adds the contours of one sheet to a scene as one lit surface, in the colors that their values have on the sheet.
// drawing: how the sheet looks.
Status addContours(const Session& session, const cut::SheetCut& sheet, std::span<const contour::Contour> contours,
                   const render::SheetDrawing& drawing, const LookChoice& choice, render::Scene& scene);

} // namespace vp::app
