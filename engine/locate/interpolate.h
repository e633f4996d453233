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

// Interpolation in a cell. Speray and Kennon leave it to the analysis code; replace this file to interpolate in another
// way.

// The weights of the points of a cell of a table shape at a place, in VTK's order. Entries beyond the shape's points
// are zero. The weights add up to 1.
struct ShapeWeights
{
	std::array<double, grid::kMaxShapePoints> weight{};
	// The depth in the cell, in its own coordinates from 0 to 1. It is 0 on the faces and negative outside.
	double depth;
};

// Returns the weights by VTK's shape functions (vtkTetra, vtkPyramid, vtkWedge, vtkHexahedron). They are linear on
// triangles and bilinear on quads, so neighbors agree on their face. Newton's method finds the place in the cell's own
// coordinates. points: of a table shape, in VTK's order, in any units. Returns nothing if the method does not converge,
// as in cells without volume, in very warped cells, and far outside.
std::optional<ShapeWeights> shapeWeights(grid::CellShape shape, std::span<const Vec3> points, const Vec3& place);

// Points of a cell and their weights at a place. The weights add up to 1. In a collapsed cell points may repeat.
struct CellWeights
{
	std::vector<PointId> points;
	std::vector<double> weights; // one for each point
	double depth;                // as in ShapeWeights; minus infinity, and no points, for a cell without volume
};

// Finds the weights in a cell of any shape and writes them to `found`. A linear field is reproduced up to rounding,
// also outside the cell. Polyhedra, and cells for which shapeWeights() returns nothing, are taken as tetrahedra.
void weighCell(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found);

// Takes the cell as tetrahedra between the mean of its points and the fans of its faces about their means. The result
// is continuous across faces, linear in each tetrahedron, and has no gap between cells of any two shapes.
void weighCellByTetrahedra(const grid::Block& block, CellId cell, const Vec3& place, CellWeights& found);

} // namespace vp::locate
