#pragma once

#include "base/ids.h"
#include "cases/case_table.h"
#include "grid/grid.h"
#include "seed/cut_cells.h"
#include "shared/slice_types.h"

#include <span>

namespace vp::find
{

// Returns the code of each case of a table shape. kCodeWalk is set if the table has no entry for the case.
const std::uint32_t* caseCodes(grid::CellShape shape);

// Returns the code of a cell of a table shape. kCodeWalk is set if the table has no entry for its case.
template <class G, class Surface>
std::uint32_t classifyByTable(const G& grid, const Surface& surface, CellId cell, grid::CellShape shape)
{
	const grid::CellPoints points = grid.cellPoints(cell);
	std::uint32_t index = 0;
	for (int v = 0; v < points.size; ++v)
		index |= static_cast<std::uint32_t>(seed::isPositive(grid, surface, points.id[v])) << v;
	return caseCodes(shape)[index];
}

// The code of any cell decided here, in double, and its faces: kCodeWalk says that the cut is to be walked from the
// faces. The faces are filled in every case; only the first eight fit the code's face bits, so use the faces of a
// walked cell.
template <class G, class Surface>
std::uint32_t classifyByWalk(const G& grid, const Surface& surface, CellId cell, grid::CellFaces& faces)
{
	grid.cellFaces(cell, faces);
	if (const grid::CellShape shape = grid.shape(cell); shape != grid::CellShape::polyhedron)
		return classifyByTable(grid, surface, cell, shape) | shared::kCodeWalk;
	for (int f = 0; f < faces.size(); ++f)
		if (seed::isFaceCut(grid, surface, faces[f]))
			return shared::kCodeCut | shared::kCodeWalk;
	return shared::kCodeWalk;
}

} // namespace vp::find
