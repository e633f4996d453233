#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <vector>

class vtkUnstructuredGrid;

namespace vp::reader::cells
{

// A grid in which all curved cells have become cells that can be sliced.
struct LinearCells
{
	vtkSmartPointer<vtkUnstructuredGrid> grid; // its points are the file's and then the added ones
	std::vector<std::int64_t> source_cells;    // per cell, ascending: the file's cell it is part of
};

// Cuts curved cells into linear ones over their own points, as VTK shows them: quadratic ones once, those of higher
// degree once per interval. Where a face or the inside lacks a point for it, one is added; further levels halve all
// edges, new points by the cell's shape functions. Prisms over pentagons and hexagons become polyhedra, and convex
// point sets tetrahedra. Cells of any other type, and hidden ones, stay. Cells that shared a face share its parts:
// faces are cut alike from either side, and diagonals lie inside cells only.
//
// Returns nothing if there is no such cell. Throws a Refusal for damaged cells and for too high a level.
std::optional<LinearCells> linearize(vtkUnstructuredGrid* grid, int level);

} // namespace vp::reader::cells
