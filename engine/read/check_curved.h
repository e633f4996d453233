#pragma once

#include "read/manifest.h"

namespace vp::read
{

// Checks that Lagrange and Bezier cells have the number of nodes that their degrees say, and that rational weights are
// above 0. After checkCells(). Throws Unusable.
void checkCurvedCells(const CellMesh& mesh);

} // namespace vp::read
