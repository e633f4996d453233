#pragma once

#include "grid/block.h"
#include "surface/curved.h"

#include <span>

namespace vp::seed
{

// S at a point: 1 where it does not lie below the surface.
template <class G, class Surface>
bool isPositive(const G& grid, const Surface& surface, PointId p)
{
	return surface::heightAt(grid, surface, p) >= 0.0;
}

// Returns true if a face has points on both sides.
template <class G, class Surface>
bool isFaceCut(const G& grid, const Surface& surface, std::span<const PointId> face)
{
	bool positive = false;
	bool negative = false;
	for (const PointId p : face)
		(isPositive(grid, surface, p) ? positive : negative) = true;
	return positive && negative;
}

// Returns true if a cell has points on both sides of a surface.
template <grid::Grid G, class Surface>
bool isCut(const G& grid, const Surface& surface, CellId cell)
{
	bool positive = false;
	bool negative = false;
	const auto see = [&](PointId p) { (isPositive(grid, surface, p) ? positive : negative) = true; };
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

// Calls visit(cell) once for each cut cell in a tree over cells of a grid. Returns the number of boxes that were asked.
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
