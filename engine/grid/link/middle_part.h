#pragma once

#include "grid/block.h"

#include <cstddef>

namespace vp::grid
{

// Cells from the middle of a block as a block of their own, finished and without arrays, to measure on: of a lattice a
// box of at most `side` cells each way, else at most side^3 cells that are numbered, and so lie, one after the other.
// They are explicit cells, whatever they were; polyhedra are left out. Coordinates are floats where no bit is lost.
Block middlePart(const Block& block, std::size_t side);

} // namespace vp::grid
