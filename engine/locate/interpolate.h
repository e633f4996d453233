#pragma once

#include "base/ids.h"
#include "base/vec.h"
#include "grid/block.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace vp::locate
{

// Interpolation in a cell, which Speray and Kennon leave to the analysis code: whoever knows better replaces this file.

// What the points of a cell of a table shape contribute to a place, in VTK's order; beyond the shape's points zero.
// They add up to 1.
struct ShapeWeights
{
	std::array<double, grid::kMaxShapePoints> weight{};
	// How far inside the cell, in its own coordinates, which run from 0 to 1: 0 on its faces, negative outside.
	double depth;
};

// By VTK's shape functions (vtkTetra, vtkPyramid, vtkWedge, vtkHexahedron): linear on triangles, bilinear on quads, so
// that neighbors agree on their face. Newton's method finds the place in the cell's own coordinates. points: of a
// table shape, in VTK's order, in any units, wherever they lie. None where the method does not end, as in cells
// without volume, in very warped ones, and far outside.
std::optional<ShapeWeights> shapeWeights(grid::CellShape shape, std::span<const Vec3> points, const Vec3& place);

// Points of a cell and what they contribute to a place. The weights add up to 1. In a collapsed cell points may repeat.
struct CellWeights
{
	std::vector<PointId> points;
	std::vector<double> weights; // as many
	double depth;                // as of ShapeWeights; minus infinity, and no points, where a cell has no volume
};

// In a cell of any shape; `found` is written over. A linear field is reproduced to rounding, outside the cell too.
// Polyhedra, and cells where shapeWeights() gives none, are taken as tetrahedra.
void weighCell(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found);

// As tetrahedra between the mean of the cell's points and the fans of its faces about their means: continuous across
// faces, linear in each tetrahedron, and without a gap between cells of any two shapes.
void weighCellByTetrahedra(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found);

} // namespace vp::locate
