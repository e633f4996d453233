#pragma once

#include "contour/box_contour.h"
#include "ranks/data/share.h"
#include "ranks/join/borders.h"

#include <optional>

namespace vp::ranks
{

/// A contour, and with a team what its mesh has in common with those of other ranks.
struct GrownContour : contour::Contour
{
	Borders borders{};
};

/// The bounds of the sheet in its frame, of all ranks together.
Box rectOverRanks(Team& team, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh);

/// Gives a contourer the values of all ranks.
void shareRange(Team& team, contour::BoxContourer& contourer);

/// Grows the contour of one value over all ranks, which have the same box. Each gets the cells and polygons of its
/// blocks that one process would find, and the number of pieces of all. Section "contour" on the timeline.
Result<GrownContour> growOverRanks(Team& team, const Share& share, const grid::BlockSet& blocks,
                                   const contour::BoxContourer& contourer, double value, Timeline* timeline);

} // namespace vp::ranks
