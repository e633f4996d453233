#pragma once

#include "render/scene/sheet_contours.h"
#include "session/session.h"

namespace vp::picture
{

// Returns what a sheet shows at the vertices or on the polygons of its mesh: its array, or generations. blocks: those
// that the cut refers to, cut::Cut::blocksOf().
render::SheetValues sheetValues(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation);

} // namespace vp::picture
