#pragma once

#include "base/result.h"
#include "cut/cutter.h"
#include "grid/check/quality.h"

#include <cstddef>
#include <vector>

namespace vp::cut
{

// Speray and Kennon's test of a grid: a plane is swept through it in three directions, and cells whose vertices lie on
// its sides in a way that no plane can part a sound cell are told.
struct SweepFindings
{
	std::vector<grid::SetCell> impossible; // ascending; cells with a case that has no entry in the tables
	std::size_t planes = 0;
	std::size_t cells = 0; // classified, each time
};

// Along x, y and z in N^(1/3) planes each (16 to 128), so that a cell is met about once a direction, between the
// lattice planes of regular grids. Cells of polyhedra have no cases and are not asked.
Result<SweepFindings> sweepForImpossibleCases(Cutter& slicer);

} // namespace vp::cut
