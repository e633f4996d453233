#pragma once

#include "grid/structured.h"

namespace vp::grid
{

// The same grid with the axis of the shortest edges running fastest in memory: a plane cuts the longest runs of cells
// along it, so fewer places in memory are gone to, by up to two times in all. The points are copied on all cores, where
// it pays; the axes are turned (i j k to j k i or k i j) and so keep their sense. See CurvilinearGrid::axes().
CurvilinearGrid withShortestEdgesFirst(CurvilinearGrid grid);

} // namespace vp::grid
