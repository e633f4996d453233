#pragma once

#include "measure/plane_lines.h"
#include "mesh/sheet_mesh.h"

#include <span>
#include <vector>

namespace vp::measure
{

// Polygons with one value each. Lines run along their edges.

// Returns the outlines of all polygons.
std::vector<PlaneLine> meshOutlines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points);

// Returns the outlines of each group, as Contours::area() does. groups: per polygon, from 0 to `count` - 1.
std::vector<std::vector<PlaneLine>> groupOutlines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points,
                                                  std::span<const std::uint32_t> groups, std::size_t count);

// Returns the lines along which a polygon at or above the level borders one below it. Higher values lie on the left.
std::vector<PlaneLine> stepLines(const mesh::SheetMesh& mesh, std::span<const glm::dvec2> points,
                                 std::span<const double> polygon_values, double level);

} // namespace vp::measure
