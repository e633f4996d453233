#pragma once

#include "measure/plane_lines.h"
#include "mesh/sheet_mesh.h"
#include "probe/transform.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vp::render
{

// What a sheet's mesh shows: a value per vertex, or per polygon; neither without an array.
struct SheetValues
{
	std::vector<double> of_vertices;
	std::vector<double> of_polygons;
};

// What lies between the corners of a polygon: towards an infinite one nothing can be interpolated, unless all are.
enum class Interpolated
{
	values,
	nothing, // some corner is NaN, or not all are infinite alike
	minus_infinity,
	plus_infinity
};
Interpolated interpolated(std::span<const std::uint32_t> polygon, std::span<const double> of_vertices);

// With NaN for what is infinite, which measure::planeTriangles() leaves out.
std::vector<double> finiteOnly(std::span<const double> values);

struct LevelLine
{
	double level;
	measure::PlaneLine line; // in the frame, grid units
};

// The contour lines of a sheet at ascending levels; of values per polygon along the polygons' edges.
std::vector<LevelLine> levelLines(const mesh::SheetMesh& mesh, const probe::Frame& frame, const SheetValues& values,
                                  std::span<const double> levels);

} // namespace vp::render
