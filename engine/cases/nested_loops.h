#pragma once

#include "cases/cell_walk.h"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace vp::cases
{

// Polygons of one cell of which one lies within another are one polygon with holes: the section of a ring, or of a cell
// with a void. It becomes one loop. From a corner of the outer polygon it runs to a corner of the hole, around the hole
// the other way, and back to where it came from. Such a bridge has no width, and no line is drawn along it
// (mesh/bridges.h). It lies within the polygon.
//
// places: where the edges of the cut lie, in a plane. A polygon within a hole is one by itself again. Polygons that
// cross each other, as in folded cells, stay as they are, and so do those of a cell with more than kMaxLoops.
void joinNestedLoops(CellCut& cut, std::span<const glm::dvec2> places);

// The work grows with the square of the loops: here it is less than a second.
constexpr int kMaxLoops = 1000;

} // namespace vp::cases
