#pragma once

#include "grid/block.h"
#include "surface/plane.h"

namespace vp::seed
{

// Whether a cell has points on both sides of the plane.
template <grid::Grid G>
bool isCut(const G& grid, const surface::Plane& plane, CellId cell)
{
	bool positive = false;
	bool negative = false;
	const auto see = [&](PointId p) { (plane.signedDistance(grid.point(p)) >= 0.0 ? positive : negative) = true; };
	if (grid.shape(cell) != grid::CellShape::polyhedron)
	{
		for (const PointId p : grid.cellPoints(cell))
			see(p);
		return positive && negative;
	}
	grid::CellFaces faces;
	grid.cellFaces(cell, faces);
	for (const PointId p : faces.points)
		see(p);
	return positive && negative;
}

// Calls visit(cell) for the cut cells of a tree over a grid's cells, each once. Returns the boxes asked.
template <grid::Grid G, class Visit>
std::size_t visitCutCells(const G& grid, const grid::BlockTree& tree, const surface::Plane& plane, Visit&& visit)
{
	return tree.visitWhere([&](const Box& box) { return plane.meets(box); },
	                       [&](CellId cell)
	                       {
		                       if (isCut(grid, plane, cell))
			                       visit(cell);
	                       });
}

} // namespace vp::seed
