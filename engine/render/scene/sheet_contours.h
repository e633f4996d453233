#pragma once

#include "measure/plane_lines.h"
#include "mesh/sheet_mesh.h"
#include "probe/transform.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::render
{

// The values that a sheet's mesh shows: one for each vertex, or one for each polygon. Both are empty without an array.
struct SheetValues
{
	std::vector<double> of_vertices;
	std::vector<double> of_polygons;
};

// The content that can be shown between the corners of a polygon. Nothing can be interpolated toward an infinite value,
// unless all corners have it.
enum class Interpolated
{
	values,
	nothing, // a corner is NaN, or some but not all have the same infinite value
	minus_infinity,
	plus_infinity
};
Interpolated interpolated(std::span<const std::uint32_t> polygon, std::span<const double> of_vertices);

// Infinite values become NaN, which measure::planeTriangles() leaves out.
std::vector<double> finiteOnly(std::span<const double> values);

struct LevelLine
{
	double level;
	measure::PlaneLine line; // in the frame, grid units
};

// Returns the contour lines of a sheet at ascending levels. If the values belong to polygons, the lines run along their
// edges.
std::vector<LevelLine> levelLines(const mesh::SheetMesh& mesh, const probe::Frame& frame, const SheetValues& values,
                                  std::span<const double> levels);

} // namespace vp::render
