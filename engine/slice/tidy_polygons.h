#pragma once

#include "slice/mesh.h"

#include <algorithm>
#include <cmath>

namespace vp::slice
{

// Drops repeated vertices, and polygons without area. In a flat mesh the rest is turned to run counter-clockwise about
// `normal`; in others (see SheetMesh::flat) polygons keep their sense and `normal` means nothing.
void tidyPolygons(SheetMesh& mesh, const Vec3& normal = Vec3(0.0));

// What the emission of a mesh leaves to the steps that look at it as a whole.
struct MeshDoubts
{
	bool at_points = false; // vertices lie at grid points, so several may lie at one
	bool slivers = false;   // polygons may have no area, or repeat a vertex

	MeshDoubts operator|(const MeshDoubts& other) const
	{
		return {at_points || other.at_points, slivers || other.slivers};
	}
};

// Turns a polygon of a flat mesh to run counter-clockwise about `normal`. One that tidyPolygons() may have to do with
// is left as it is, and the result is false. positions: of the vertices that the polygon names.
inline bool turnPolygon(const Vec3* positions, const Vec3& normal, std::span<std::uint32_t> polygon)
{
	if (polygon.size() < 3)
		return false;
	const Vec3 first = positions[polygon[0]];
	Vec3 to_previous = positions[polygon[1]] - first;
	bool repeats = polygon[0] == polygon[1] || polygon[0] == polygon.back();
	double square = glm::dot(to_previous, to_previous); // of the farthest corner's distance
	Vec3 sum(0.0);
	for (std::size_t v = 2; v < polygon.size(); ++v)
	{
		repeats = repeats || polygon[v] == polygon[v - 1];
		const Vec3 to_next = positions[polygon[v]] - first;
		sum += glm::cross(to_previous, to_next);
		square = std::max(square, glm::dot(to_next, to_next));
		to_previous = to_next;
	}
	const double area = glm::dot(sum, normal);
	constexpr double kThin = 1e-12; // well above what tidyPolygons() takes for no area
	if (repeats || std::abs(area) <= kThin * square)
		return false;
	if (area < 0.0)
		std::reverse(polygon.begin(), polygon.end());
	return true;
}
inline bool turnPolygon(const SheetMesh& mesh, const Vec3& normal, std::span<std::uint32_t> polygon)
{
	return turnPolygon(mesh.positions.data(), normal, polygon);
}

} // namespace vp::slice
