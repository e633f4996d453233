#pragma once

#include "render/scene/sheet_contours.h"
#include "session/sheet_stats.h"

namespace vp::picture
{

// Returns what a sheet shows at the vertices or on the polygons of its mesh: its array, or generations. blocks: those
// that the cut refers to, cut::Cut::blocksOf().
render::SheetValues sheetValues(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh,
                                bool by_generation);

/// The polygons of a sheet as they are drawn, and their values.
struct ShownPolygons
{
	const mesh::SheetMesh& mesh; // it belongs to the sheet's figures
	render::SheetValues values;
};

/// Returns what is drawn of a sheet: its whole cells where those are shown, parts of one category each where the array
/// names categories.
ShownPolygons shownPolygons(const grid::BlockSet& blocks, const cut::SheetCut& sheet, const session::SheetStats& stats,
                            bool by_generation);

} // namespace vp::picture
