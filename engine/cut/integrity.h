#pragma once

#include "base/result.h"
#include "cut/cutter.h"
#include "grid/check/quality.h"

#include <cstddef>
#include <vector>

namespace vp::cut
{

// Speray and Kennon's test of a grid: a plane is swept through it in three directions. A cell is reported if its
// vertices lie on the two sides of the plane in a way that is impossible for a sound cell.
struct SweepFindings
{
	std::vector<grid::SetCell> impossible; // ascending; cells whose case has no entry in the tables
	std::size_t planes = 0;
	std::size_t cells = 0; // number of classified cells, each time counted
};

// There are N^(1/3) planes (16 to 128) along each of x, y and z, so each cell is cut about once in each direction.
// They lie between the lattice planes of regular grids. Polyhedra have no cases and are not tested.
Result<SweepFindings> sweepForImpossibleCases(Cutter& slicer);

} // namespace vp::cut
