#pragma once

#include "contour/box_contour.h"
#include "ranks/join/borders.h"

#include <span>
#include <vector>

namespace vp::ranks
{

/// A contour, and with a team what its mesh has in common with those of other ranks.
struct GrownContour : contour::Contour
{
	Borders borders{};
};

/// Returns the bounds of the sheet in its frame, of all ranks together.
Box rectOf(const Ranks& ranks, const cut::SheetCut& sheet, const mesh::SheetMesh& mesh);

/// Gives a contourer the values of all ranks.
void shareRange(const Ranks& ranks, contour::BoxContourer& contourer);

/// Grows the contours of some values over all ranks, which have the same box. Each gets the cells and polygons of its
/// blocks that one process would find, and the number of pieces of all. Section "contour" on the timeline.
Result<std::vector<GrownContour>> growContours(const Ranks& ranks, const grid::BlockSet& blocks,
                                               const contour::BoxContourer& contourer, std::span<const double> values,
                                               Timeline* timeline);

} // namespace vp::ranks
