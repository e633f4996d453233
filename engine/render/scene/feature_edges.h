#pragma once

#include "grid/block.h"
#include "render/scene/outline.h"

#include <vector>

namespace vp::render
{

// If the dihedral angle between two boundary faces is larger, their edge is drawn.
constexpr double kFeatureAngle = 30.0; // degrees

// Appends the edges of the block's boundary that are sharp or do not belong to exactly two faces. Faces are matched by
// sorting their edges, which takes n log n time in the size of the boundary.
void addFeatureEdges(const grid::Block& block, std::vector<Segment>& segments);

} // namespace vp::render
