#pragma once

#include "grid/block.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::render
{

// Dihedral angle between boundary faces above which their edge is drawn.
constexpr double kFeatureAngle = 30.0; // degrees

// Appends the edges of the block's boundary that are sharp or not shared by exactly two faces. Faces are matched by
// sorting their edges: n log n in the boundary, whatever the grid.
void addFeatureEdges(const grid::Block& block, std::vector<Segment>& segments);

} // namespace vp::render
