#pragma once

#include "grid/block.h"
#include "grid/cell_filter.h"
#include "seed/seeds.h"
#include "surface/curved.h"

#include <span>

namespace vp::seed
{

// Generation 0 of a curved surface. The surface may close anywhere, also away from the boundary, so the block tree is
// searched. In every leaf that the surface may pass through, the cells are classified. Each of the leaf's pieces (cut
// cells that are connected through cut faces within the leaf) gives a seed. So every piece is found, and fronts are
// wide. SheetSeeds::tree_tests counts the boxes and cells tested. With SeedMode::boundary the tree is not used. With
// SeedMode::hotspot there is one seed: the cut cell nearest along the sheet's axes from its origin, the normal first.
//
// surfaces: as each block sees it. sheet: placed; its window, if it has one, bounds what is looked for. filters: per
// block, cells that it turns down are not there; an empty function, or no functions: all are.
SheetSeeds findSeeds(const grid::BlockSet& blocks, std::span<const surface::BlockSurface> surfaces,
                     const probe::Sheet& sheet, SeedMode mode, std::span<const grid::CellFilter> filters = {});

} // namespace vp::seed
