#pragma once

#include "grid/block.h"

#include <span>
#include <vector>

namespace vp::grid
{

/// The boundary faces of each block among which matches are looked for, one span a block.
using FacesOfBlocks = std::vector<std::span<const BoundaryIndex::Face>>;

/// The faces that lie on each other, see matchInterfaces(): per block the links from its side, in no order.
std::vector<std::vector<SeamLink>> matchFaces(const BlockSet& blocks, const FacesOfBlocks& faces);

} // namespace vp::grid
