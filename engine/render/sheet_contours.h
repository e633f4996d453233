#pragma once

#include "probe/transform.h"
#include "slice/mesh.h"
#include "slice/plane_lines.h"

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

struct LevelLine
{
	double level;
	slice::PlaneLine line; // in the frame, grid units
};

// The contour lines of a sheet at ascending levels; of values per polygon along the polygons' edges.
std::vector<LevelLine> levelLines(const slice::SheetMesh& mesh, const probe::Frame& frame, const SheetValues& values,
                                  std::span<const double> levels);

} // namespace vp::render
