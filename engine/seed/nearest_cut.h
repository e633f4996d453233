#pragma once

#include "seed/cut_cells.h"
#include "seed/sheet_window.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vp::seed
{

// A hot spot on a face or a vertex may be found in the cell whose vertices all count as positive. The cut cell is near:
// looked for across faces, ring by ring, among this many cells (two rings of hexahedra and their corners). So is the
// one whose section holds a window that is smaller than a cell: where faces are warped it may be beside the one found.
inline constexpr std::size_t kNearbyCells = 64;

// start: a cell that holds the hot spot. With a window (or null) the section reaches into it. kNoCell where none is
// near.
template <grid::Grid G, class Surface>
CellId nearestCutCell(const G& grid, const Surface& surface, const SheetWindow* window, CellId start)
{
	std::vector<CellId> queue{start};
	grid::CellFaces faces;
	for (std::size_t i = 0; i < queue.size(); ++i)
	{
		if (isCut(grid, surface, queue[i]))
		{
			if (!window)
				return queue[i];
			grid.cellFaces(queue[i], faces);
			if (window->meetsCell(grid, surface, faces))
				return queue[i];
		}
		for (int f = 0; f < grid.faceCount(queue[i]); ++f)
			grid.forEachNeighbor(queue[i], f,
			                     [&](CellId n)
			                     {
				                     if (queue.size() < kNearbyCells &&
				                         std::find(queue.begin(), queue.end(), n) == queue.end())
					                     queue.push_back(n);
			                     });
	}
	return kNoCell;
}

} // namespace vp::seed
