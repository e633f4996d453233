#pragma once

#include "mesh/sheet_mesh.h"
#include "probe/transform.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vp::measure
{

using PlaneTriangle = std::array<std::uint32_t, 3>; // counter-clockwise, seen against the sheet's normal

// A sheet's polygons as triangles in its plane, with values that are linear in each. A polygon of more than three
// corners is the fan about the mean of its corners, whose value is the mean of theirs, as in measure() (stats.h); where
// that fan folds over, as in some polygons that are not convex, it is cut into fans about its own corners.
struct PlaneTriangles
{
	std::vector<glm::dvec2> points; // the mesh's vertices, then the means; see planePoints()
	std::vector<double> values;     // values at the points
	std::vector<PlaneTriangle> triangles;
	std::vector<PlaneTriangle> nan_triangles; // triangles of polygons that have a corner with value NaN
	std::size_t vertices = 0;                 // number of vertices of the mesh
};

// A place along the frame's x and y axes, from its origin, in the grid's units.
glm::dvec2 planePoint(const Vec3& position, const probe::Frame& frame);

// Returns the places of the mesh's vertices.
std::vector<glm::dvec2> planePoints(const mesh::SheetMesh& mesh, const probe::Frame& frame);

// values: one for each vertex of the mesh.
PlaneTriangles planeTriangles(const mesh::SheetMesh& mesh, const probe::Frame& frame, std::span<const double> values);

} // namespace vp::measure
