#pragma once

#include "session/grown_contours.h"

namespace vp::picture
{

// Adds the contours of one sheet to a scene as one lit surface, in the colors that their values have on the sheet.
// drawing: how the sheet looks. All ranks call it together.
Status addContours(const session::Session& session, const cut::SheetCut& sheet,
                   std::span<const ranks::GrownContour> contours, const render::SheetDrawing& drawing,
                   const view::ResolvedLook& choice, render::Scene& scene);

} // namespace vp::picture
