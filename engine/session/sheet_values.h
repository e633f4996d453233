#pragma once

#include "render/scene/sheet_contours.h"
#include "session/session.h"

namespace vp::session
{

// What a sheet shows at its mesh's vertices or on its polygons: its array, or generations.
render::SheetValues sheetValues(const Session& session, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation);

} // namespace vp::session
