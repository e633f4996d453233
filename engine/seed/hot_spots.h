#pragma once

#include "grid/block.h"
#include "probe/sheet.h"
#include "seed/boundary_cut.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vp::seed
{

// Cells that were found along the lines of a lattice over a sheet.
struct HotSpots
{
	std::vector<CellId> cells; // all are cut; a cell may come twice
	std::size_t hops = 0;      // cells passed
};

// More seeds for a sheet in one block, so that a traversal takes few generations: every cut cell is to be within
// kLatticeCells / 2 cells of a seed. Lines parallel to the sheet's x axis are walked from side to side; where cells are
// small the lines between them are reached by hops across. They start at the block's rim, and in a window (which the
// sheet may have, but no fx) at the first seed. rim: the cut boundary faces in the window, seeds: generation 0 without
// these. The same for any number of threads. Cells without a case table are not passed.
HotSpots spreadHotSpots(const grid::Block& block, const probe::Sheet& sheet, std::span<const CutFace> rim,
                        std::span<const CellId> seeds);

// Between two lines of the lattice, where a cell's section reaches 1 far. 12 leave 9 to 13 generations in grids of
// hexahedra, 14 in those of tetrahedra, with hops of some 12 % of the cut cells; these grow as the inverse.
constexpr double kLatticeCells = 12.0;

} // namespace vp::seed
